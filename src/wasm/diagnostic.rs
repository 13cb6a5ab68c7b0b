//! Diagnostics as they go out.

use crate::document::Diagnostic;
use crate::matching::Obstacle;
#[cfg(feature = "solid")]
use glam::DVec2;
use serde::Serialize;

#[derive(Serialize, Default)]
pub(super) struct DiagnosticResult {
    code: &'static str,
    message: String,
    #[cfg(feature = "stack")]
    #[serde(skip_serializing_if = "Option::is_none")]
    span: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    curve: Option<usize>,
    #[cfg(feature = "harmonic")]
    #[serde(skip_serializing_if = "Option::is_none")]
    curves: Option<Vec<usize>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    vertices: Option<Vec<usize>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    lines: Option<Vec<usize>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pins: Option<Vec<usize>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    reason: Option<&'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    parameter: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    turn: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    normal: Option<[f64; 2]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    at: Option<[f64; 2]>,
}

#[cfg(feature = "solid")]
impl DiagnosticResult {
    /// A remark that speaks of nothing more than a curve and a place.
    pub(super) fn remark(
        code: &'static str,
        message: String,
        curve: Option<usize>,
        at: Option<DVec2>,
    ) -> Self {
        Self { code, message, curve, at: at.map(|at| at.to_array()), ..Self::default() }
    }
}

impl From<&Diagnostic> for DiagnosticResult {
    fn from(diagnostic: &Diagnostic) -> Self {
        let mut result = Self { code: diagnostic.code(), message: diagnostic.to_string(), ..Self::default() };
        match diagnostic {
            Diagnostic::Corner { curve, parameter, at, turn, normal } => {
                result.curve = Some(*curve);
                result.parameter = Some(*parameter);
                result.turn = Some(*turn);
                result.normal = Some(normal.to_array());
                result.at = Some(at.to_array());
            }
            Diagnostic::OpposedNormals { lines }
            | Diagnostic::Occluded { lines }
            | Diagnostic::Unverified { lines } => result.lines = Some(lines.clone()),
            Diagnostic::Pins { pins, obstacle } => {
                result.pins = Some(pins.clone());
                result.reason = Some(match obstacle {
                    Obstacle::PinsCross { .. } => "cross",
                    Obstacle::NoRoom { .. } => "no-room",
                    _ => "blocked",
                });
            }
            Diagnostic::Orphan { curve, vertices }
            | Diagnostic::Stuck { curve, vertices }
            | Diagnostic::LeftOut { curve, vertices }
            | Diagnostic::Jammed { curve, vertices } => {
                result.curve = Some(*curve);
                result.vertices = Some(vertices.clone());
            }
            Diagnostic::Incomplete { .. }
            | Diagnostic::Disjoint
            | Diagnostic::Solvable
            | Diagnostic::Ends { .. } => {}
            Diagnostic::SampleLimit { curve } => result.curve = Some(*curve),
            Diagnostic::UnverifiedGap { lines, at } => {
                result.lines = Some(lines.clone());
                result.at = Some(at.to_array());
            }
            Diagnostic::Crossing { at } => result.at = Some(at.to_array()),
            Diagnostic::CoarseSampling { at } => result.at = at.map(|at| at.to_array()),
            #[cfg(feature = "stack")]
            Diagnostic::InSpan { span, remark } => {
                result = Self { message: result.message, span: Some(*span), ..Self::from(&**remark) };
            }
            #[cfg(feature = "stack")]
            Diagnostic::Order { curve, at } => {
                result.curve = Some(*curve);
                result.at = Some(at.to_array());
            }
            #[cfg(feature = "stack")]
            Diagnostic::Overlap { span, at } => {
                result.span = Some(*span);
                result.at = Some(at.to_array());
            }
            #[cfg(feature = "stack")]
            Diagnostic::NoThread => {}
            #[cfg(feature = "harmonic")]
            Diagnostic::SeveralInner { curves, .. }
            | Diagnostic::OpenCurves { curves }
            | Diagnostic::HeightsIgnored { curves } => result.curves = Some(curves.clone()),
            #[cfg(feature = "harmonic")]
            Diagnostic::CurvesMeet { curves, at } | Diagnostic::Nested { curves, at } => {
                result.curves = Some(curves.to_vec());
                result.at = Some(at.to_array());
            }
            #[cfg(feature = "harmonic")]
            Diagnostic::NoOuter { curves, at } => {
                result.curves = Some(curves.clone());
                result.at = Some(at.to_array());
            }
            #[cfg(feature = "harmonic")]
            Diagnostic::NoField { at, .. } => result.at = at.map(|at| at.to_array()),
            #[cfg(feature = "harmonic")]
            Diagnostic::LostLines { .. } | Diagnostic::NoRuledBlend => {}
        }
        result
    }
}
