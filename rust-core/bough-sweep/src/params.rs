//! Params from JSON, by the one declaration: their flat form, and all that is wrong with them.

use bough::params::{BoughError, Issue, Kind, PARAMETERS, Parameter, Params, check_flat};
use serde_json::{Map, Value};

use crate::text::{described, shortened};

/// Why a line is no plant.
#[derive(Debug)]
pub(crate) struct Problem {
    /// All sentences.
    pub(crate) message: String,
    /// Every problem with the params; empty if the line could not be read at all.
    pub(crate) issues: Vec<Said>,
}

/// One issue as it is written.
#[derive(Debug)]
pub(crate) struct Said {
    pub(crate) code: &'static str,
    pub(crate) path: String,
    pub(crate) message: String,
}

impl Problem {
    /// Of a line that is no params.
    pub(crate) fn of_line(message: String) -> Self {
        Problem { message, issues: Vec::new() }
    }

    fn of(issues: Vec<Said>) -> Self {
        let messages: Vec<_> = issues.iter().map(|issue| issue.message.as_str()).collect();
        Problem { message: messages.join(" "), issues }
    }
}

impl From<BoughError> for Problem {
    fn from(error: BoughError) -> Self {
        Problem::of(error.issues.iter().map(Said::from).collect())
    }
}

impl From<&Issue> for Said {
    fn from(issue: &Issue) -> Self {
        Said { code: issue.code, path: issue.path.to_owned(), message: issue.message() }
    }
}

/// Params that a plant can be grown from. What is left out takes its default.
pub(crate) fn read(given: &Value) -> Result<Params, Problem> {
    let mut reader = Reader { flat: Vec::new(), forces: Vec::new(), issues: Vec::new() };
    let empty = Map::new();
    let groups = reader.object("", given).unwrap_or(&empty);
    let mut open = ("", &empty);
    for parameter in PARAMETERS {
        let (group, field) = parameter.path.split_once('.').unwrap_or_default();
        if group != open.0 {
            let fields = groups.get(group).and_then(|fields| reader.object(group, fields));
            open = (group, fields.unwrap_or(&empty));
        }
        reader.value(parameter, open.1.get(field));
    }
    let Reader { mut flat, forces, mut issues } = reader;
    flat.extend(forces);
    let misshapen: Vec<_> = issues.iter().map(|issue| issue.path.clone()).collect();
    let found = check_flat(&flat);
    let ranges = found.iter().filter(|issue| !misshapen.iter().any(|path| path == issue.path));
    issues.extend(ranges.map(Said::from));
    issues.extend(unknown_keys(groups));
    if issues.is_empty() { Ok(Params::from_flat(&flat)) } else { Err(Problem::of(issues)) }
}

struct Reader {
    flat: Vec<f64>,
    forces: Vec<f64>,
    issues: Vec<Said>,
}

impl Reader {
    fn object<'a>(&mut self, path: &str, given: &'a Value) -> Option<&'a Map<String, Value>> {
        if let Value::Object(fields) = given {
            return Some(fields);
        }
        let name = if path.is_empty() { "params" } else { path };
        let message = format!("{name} must be an object with named values; it is {}.", described(given));
        self.issues.push(Said { code: "wrongType", path: path.to_owned(), message });
        None
    }

    /// Appends the numbers of a parameter. A value of the wrong structure is NaN there, so that the core neither accepts it nor
    /// looks at combinations with it.
    fn value(&mut self, parameter: &Parameter, given: Option<&Value>) {
        let Some(given) = given else {
            self.flat.extend(parameter.default);
            return;
        };
        let numbers = numbers(parameter.kind, given);
        if numbers.is_none() {
            self.issues.push(Said::from(&parameter.wrong_type(&described(given), given.is_string())));
        }
        let list = if parameter.kind == Kind::Forces { &mut self.forces } else { &mut self.flat };
        list.extend(numbers.unwrap_or_else(|| vec![f64::NAN; parameter.kind.width()]));
    }
}

fn unknown_keys(groups: &Map<String, Value>) -> Vec<Said> {
    let mut issues = Vec::new();
    let mut unknown = |path: String, known: &str| {
        let message = format!("{path} is not a parameter; {known}.");
        issues.push(Said { code: "unknownKey", path, message });
    };
    for (group, fields) in groups {
        let known = fields_of(group);
        if known.is_empty() {
            unknown(shortened(group), "params have groups, as {\"loads\": {\"gravity\": 3}}");
            continue;
        }
        for field in fields.as_object().into_iter().flat_map(Map::keys) {
            if !known.contains(&field.as_str()) {
                let holds = format!("{group} may hold {}", known.join(", "));
                unknown(format!("{group}.{}", shortened(field)), &holds);
            }
        }
    }
    issues
}

/// What a group may hold.
fn fields_of(group: &str) -> Vec<&'static str> {
    let paths = PARAMETERS.iter().filter_map(|parameter| parameter.path.split_once('.'));
    paths.filter(|(own, _)| *own == group).map(|(_, field)| field).collect()
}

/// The flat form of a value; none if it has another structure.
fn numbers(kind: Kind, given: &Value) -> Option<Vec<f64>> {
    match kind {
        Kind::Number | Kind::Integer => Some(vec![number(given)?]),
        Kind::Optional if given.is_null() => Some(vec![f64::NAN]),
        Kind::Optional => Some(vec![number(given)?]),
        Kind::Flag => Some(vec![f64::from(u8::from(given.as_bool()?))]),
        Kind::Choice(options) => {
            let name = given.as_str()?;
            Some(vec![options.iter().position(|option| *option == name)? as f64])
        }
        Kind::Vector => vector(given),
        Kind::Forces => {
            let mut flat = Vec::new();
            for one in given.as_array()? {
                flat.push(number(one.get("segment")?)?);
                flat.extend(vector(one.get("force")?)?);
            }
            Some(flat)
        }
    }
}

fn vector(given: &Value) -> Option<Vec<f64>> {
    let numbers: Vec<_> = given.as_array()?.iter().map(number).collect::<Option<_>>()?;
    (numbers.len() == 3).then_some(numbers)
}

/// Negative zero is zero.
fn number(given: &Value) -> Option<f64> {
    Some(given.as_f64()? + 0.0)
}
