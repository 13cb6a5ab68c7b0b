//! What a solver of Laplace's equation is asked for.

use super::{Code, DocumentError, Json, Node};
use crate::laplace::{
    Conditions, Frame, GmresOptions, LaplaceError, LaplaceOptions, MOST_DENSE, MOST_MATERIALS, MOST_PIXELS,
    Mesh, Method, Preconditioner, Problem, Solution,
};
use glam::{DVec2, DVec3};

/// Greatest size of a coordinate of a section.
const LARGEST: f64 = 1e100;

/// A problem and how it is solved, but for the long lists; see `docs/api.md`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LaplaceInput {
    /// 2 or 3.
    pub dimension: usize,
    /// Number of materials.
    pub materials: usize,
    /// Whether they are fractions that sum to 1.
    pub are_fractions: bool,
    /// How the equations are solved.
    pub options: LaplaceOptions,
}

/// The long lists of a problem.
#[derive(Debug, Clone, Copy)]
pub struct LaplaceLists<'a> {
    /// As many numbers a vertex as there are dimensions.
    pub vertices: &'a [f64],
    /// As many vertices an element as there are dimensions.
    pub elements: &'a [u32],
    /// Of each element 1 where values are given, 0 where fluxes are.
    pub is_value: &'a [u8],
    /// As many numbers an element as there are materials.
    pub data: &'a [f64],
}

impl LaplaceInput {
    /// Reads options.
    ///
    /// # Errors
    /// When a field is unknown, missing, of the wrong type or out of range, with its path.
    pub fn read(options: &Json) -> Result<Self, DocumentError> {
        let root = Node::root(options, "");
        root.only(&["dimension", "materials", "composition", "solver"])?;
        let dimension = root.need("dimension")?.count_within(2..=3)?;
        let materials = root.need("materials")?.count_within(1..=MOST_MATERIALS)?;
        let are_fractions = root.get("composition")?.map_or(Ok(false), |node| node.flag())?;
        let options =
            root.get("solver")?.map_or_else(|| Ok(LaplaceOptions::default()), |node| solver(&node))?;
        Ok(Self { dimension, materials, are_fractions, options })
    }

    /// The problem of these lists.
    ///
    /// # Errors
    /// When it is none, with the element and the place.
    pub fn problem(&self, lists: LaplaceLists<'_>) -> Result<Problem, LaplaceError> {
        let mesh = if self.dimension == 2 {
            let vertices: Vec<DVec2> =
                lists.vertices.as_chunks::<2>().0.iter().map(|v| DVec2::from_array(*v)).collect();
            Mesh::plane(&vertices, lists.elements.as_chunks::<2>().0)?
        } else {
            let vertices = lists.vertices.as_chunks::<3>().0.iter().map(|v| DVec3::from_array(*v)).collect();
            Mesh::solid(vertices, lists.elements.as_chunks::<3>().0.to_vec())?
        };
        let column =
            |material: usize| lists.data.iter().skip(material).step_by(self.materials).copied().collect();
        let conditions = Conditions {
            is_value: lists.is_value.iter().map(|flag| *flag != 0).collect(),
            data: (0..self.materials).map(column).collect(),
            are_fractions: self.are_fractions,
        };
        Problem::new(mesh, conditions)
    }
}

/// How the equations are solved.
pub(super) fn solver(node: &Node<'_>) -> Result<LaplaceOptions, DocumentError> {
    node.only(&[
        "method",
        "preconditioner",
        "omega",
        "restart",
        "tolerance",
        "maxIterations",
        "condition",
        "dense",
    ])?;
    let default = GmresOptions::default();
    let is_lu = node.get("method")?.map_or(Ok(0), |n| n.choice(&["gmres", "lu"]))? == 1;
    let omega = node.get("omega")?;
    let preconditioner =
        match node.get("preconditioner")?.map_or(Ok(1), |n| n.choice(&["none", "jacobi", "ssor"]))? {
            0 => Preconditioner::None,
            1 => Preconditioner::Jacobi,
            _ => Preconditioner::Ssor(omega.map_or(Ok(0.5), |n| n.within(0.01..=1.99))?),
        };
    if let (Some(omega), false) = (omega, matches!(preconditioner, Preconditioner::Ssor(_))) {
        let message = "it was found without the preconditioner `ssor`, whose parameter it is";
        return Err(omega.error(Code::Range, message.to_owned()));
    }
    let gmres = GmresOptions {
        preconditioner,
        restart: node.get("restart")?.map_or(Ok(default.restart), |n| n.count_within(1..=1000))?,
        tolerance: node.get("tolerance")?.map_or(Ok(default.tolerance), |n| n.within(1e-12..=0.1))?,
        most_iterations: node
            .get("maxIterations")?
            .map_or(Ok(default.most_iterations), |n| n.count_within(1..=5000))?,
    };
    Ok(LaplaceOptions {
        method: if is_lu { Method::Lu } else { Method::Gmres(gmres) },
        with_condition: node.get("condition")?.map_or(Ok(false), |n| n.flag())?,
        most_dense: node.get("dense")?.map_or(Ok(MOST_DENSE), |n| n.count_within(0..=MOST_DENSE))?,
    })
}

/// Reads the pixels of a section: `origin`, `sides` and `size`; in the plane `longest` may stand for all of them.
///
/// # Errors
/// When a field is unknown, missing, of the wrong type or out of range, with its path.
pub fn read_frame(options: &Json, solution: &Solution) -> Result<Frame, DocumentError> {
    let root = Node::root(options, "");
    root.only(&["origin", "sides", "size", "longest"])?;
    let dimension = solution.problem().mesh().space().dimension();
    if let Some(longest) = root.get("longest")? {
        if dimension == 3 {
            return Err(longest.error(
                Code::Range,
                "it was found in space; expected `origin`, `sides` and `size`".to_owned(),
            ));
        }
        root.only(&["longest"])?;
        return Ok(Frame::of_plane(solution, longest.count_within(1..=2048)?));
    }
    let vector = |node: &Node<'_>| -> Result<DVec3, DocumentError> {
        let items = node.items()?;
        node.check_count(items.len(), " coordinates", dimension..=dimension)?;
        let mut vector = [0.0; 3];
        for (part, item) in vector.iter_mut().zip(&items) {
            *part = item.within(-LARGEST..=LARGEST)?;
        }
        Ok(DVec3::from_array(vector))
    };
    let sides = root.need("sides")?;
    let items = sides.items()?;
    sides.check_count(items.len(), " sides", 2..=2)?;
    let size = root.need("size")?;
    let counts = size.items()?;
    size.check_count(counts.len(), " numbers", 2..=2)?;
    Ok(Frame {
        origin: vector(&root.need("origin")?)?,
        sides: [vector(&items[0])?, vector(&items[1])?],
        size: [counts[0].count_within(1..=MOST_PIXELS)?, counts[1].count_within(1..=MOST_PIXELS)?],
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::{Value, json};

    fn read(value: Value) -> Result<LaplaceInput, DocumentError> {
        LaplaceInput::read(&Json::from(value))
    }

    #[test]
    fn options_are_read_with_their_defaults() {
        let plain = read(json!({"dimension": 3, "materials": 1})).unwrap();
        assert_eq!((plain.options, plain.are_fractions), (LaplaceOptions::default(), false));
        let solver = json!({"preconditioner": "ssor", "restart": 20, "tolerance": 1e-8, "maxIterations": 99, "condition": true});
        let options = read(json!({"dimension": 2, "materials": 2, "composition": true, "solver": solver}))
            .unwrap()
            .options;
        let gmres = GmresOptions {
            preconditioner: Preconditioner::Ssor(0.5),
            restart: 20,
            tolerance: 1e-8,
            most_iterations: 99,
        };
        assert_eq!((options.method, options.with_condition), (Method::Gmres(gmres), true));
        assert_eq!(
            read(json!({"dimension": 2, "materials": 2, "solver": {"method": "lu"}})).unwrap().options.method,
            Method::Lu
        );
    }

    #[test]
    fn wrong_options_are_refused_with_their_path() {
        let refused = |solver: Value| {
            let error = read(json!({"dimension": 3, "materials": 1, "solver": solver})).unwrap_err();
            (error.code, error.path)
        };
        assert_eq!(refused(json!({"method": "qr"})), (Code::Range, "solver.method".into()));
        assert_eq!(refused(json!({"omega": 0.5})), (Code::Range, "solver.omega".into()));
        assert_eq!(
            refused(json!({"preconditioner": "ssor", "omega": 2})),
            (Code::Range, "solver.omega".into())
        );
        assert_eq!(refused(json!({"tolerance": 0})), (Code::Range, "solver.tolerance".into()));
        assert_eq!(refused(json!({"speed": 0})), (Code::UnknownField, "solver.speed".into()));
        assert_eq!(read(json!({"dimension": 4, "materials": 1})).unwrap_err().path, "dimension");
    }
}
