//! A strict reader of the XML that the SVG writer may use.

/// Whether XML can hold a character.
pub(crate) fn is_xml(c: char) -> bool {
    matches!(c, '\t' | '\n' | '\r' | '\u{20}'..='\u{d7ff}' | '\u{e000}'..='\u{fffd}' | '\u{10000}'..)
}

/// A strict reader of the XML that the writer may use: the elements in order of their start, each with its own text. Refuses
/// anything not well formed, ids given twice, comments, instructions and attributes that run scripts or load things.
pub(crate) fn elements(xml: &str) -> Result<Vec<(String, String)>, String> {
    let mut found: Vec<(String, String)> = Vec::new();
    let mut open: Vec<usize> = Vec::new();
    let mut ids = std::collections::HashSet::new();
    let mut rest = xml;
    while let Some(start) = rest.find('<') {
        let (text, tail) = rest.split_at(start);
        match open.last() {
            Some(&i) => found[i].1 += &unescape(text)?,
            None if text.trim().is_empty() => {}
            None => return Err(format!("text outside: {text:?}")),
        }
        let end = tail.find('>').ok_or("a tag without end")?;
        let tag = &tail[1..end];
        rest = &tail[end + 1..];
        if let Some(name) = tag.strip_prefix('/') {
            let i = open.pop().ok_or("an end without start")?;
            if found[i].0 != name {
                return Err(format!("{name} ends {}", found[i].0));
            }
            continue;
        }
        let (tag, empty) = tag.strip_suffix('/').map_or((tag, false), |tag| (tag, true));
        let (name, mut attributes) = tag.split_once(' ').unwrap_or((tag, ""));
        if !name.chars().all(|c| c.is_ascii_alphabetic()) || name.is_empty() {
            return Err(format!("element {name:?}"));
        }
        while !attributes.is_empty() {
            let (key, value) =
                attributes.split_once("=\"").ok_or_else(|| format!("attributes {attributes:?}"))?;
            let (value, more) = value.split_once('"').ok_or("an attribute without end")?;
            // A reference inside the document loads nothing.
            let loads = key == "href" && !value.starts_with('#');
            if !key.chars().all(|c| c.is_ascii_alphanumeric() || c == '-') || key.starts_with("on") || loads {
                return Err(format!("attribute {key:?}"));
            }
            if value.contains('<') || unescape(value)? != value {
                return Err(format!("value {value:?}"));
            }
            if key == "id" && !ids.insert(value.to_owned()) && !value.starts_with("clip-") {
                return Err(format!("id {value} twice"));
            }
            attributes = more.trim_start();
        }
        found.push((name.to_owned(), String::new()));
        if !empty {
            open.push(found.len() - 1);
        }
    }
    if !rest.trim().is_empty() || !open.is_empty() {
        return Err("the document does not end where its root does".to_owned());
    }
    Ok(found)
}

fn unescape(text: &str) -> Result<String, String> {
    let mut parts = text.split('&');
    let mut plain = parts.next().unwrap_or("").to_owned();
    for part in parts {
        let (entity, more) = part.split_once(';').ok_or_else(|| format!("a bare & before {part:?}"))?;
        plain.push(match entity {
            "amp" => '&',
            "lt" => '<',
            "gt" => '>',
            "quot" => '"',
            "apos" => '\'',
            "#13" => '\r',
            _ => return Err(format!("entity {entity:?}")),
        });
        plain += more;
    }
    match plain.chars().find(|&c| !is_xml(c)) {
        Some(c) => Err(format!("character {c:?}")),
        None => Ok(plain),
    }
}
