project = "A site"
html_js_files = [("https://directrix.example/element.js", {"type": "module"})]
