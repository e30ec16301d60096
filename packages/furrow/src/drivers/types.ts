/** A point of a piecewise-linear curve: input, output. */
export type CurvePoint = [input: number, output: number]

/** Two or more points with growing inputs; constant beyond its ends. */
export type Curve = CurvePoint[]

/** What goes in comes out, within 0..1. */
export const STRAIGHT: Readonly<Curve> = [
  [0, 0],
  [1, 1],
]

/**
 * How the links of one driver meet: added, the largest, the smallest (two brows lowered together crease the middle), or
 * multiplied (one gates the other).
 */
export type Rule = 'sum' | 'max' | 'min' | 'product'

/** One input of a driver, by name: its value through the curve, if there is one, times the weight. */
export interface Link {
  name: string
  /** Of either sign. */
  weight: number
  curve?: Curve
}

/** Activates an area by blendshapes: the curve of its links to them, joined by the rule. */
export interface MorphDriver {
  type: 'morph'
  /** Name of the area. */
  area: string
  targets: Link[]
  rule: Rule
  curve: Curve
}

/** Activates an area by other areas: the curve of its links to their activations. */
export interface AreaDriver {
  type: 'area'
  area: string
  areas: Link[]
  rule: Rule
  curve: Curve
}

/**
 * Two blendshapes that undo each other, as raising and lowering one brow: what both have is taken from both, before any driver
 * reads them. The mesh itself moves as it did.
 */
export interface ConflictDriver {
  type: 'conflict'
  targets: [string, string]
}

/** Activates an area by a joint: how far it has turned, or how far it is from another. */
export interface BoneDriver {
  type: 'bone'
  area: string
  /** Names of two nodes: what the joint is measured from, and the joint. */
  joints: [from: string, joint: string]
  /** `angle`: radians by which the joint is turned from its rest, as seen from the other. `distance`: metres between the two. */
  measure: 'angle' | 'distance'
  /** Of an angle: the axis it is counted about, in the frame of the joint at rest, signed; absent: about whatever axis. */
  axis?: [number, number, number]
  curve: Curve
}

/** Activates an area by what happens to the skin under it, whatever deforms the mesh. */
export interface TensionDriver {
  type: 'tension'
  area: string
  /** `compression`: share by which skin is shortened where it is shortened most; `stretch`: by which it is lengthened. */
  measure: 'compression' | 'stretch'
  curve: Curve
}

/**
 * A virtual muscle (Waters 1987): it pulls the skin in its zone as a morph target of its name, whose weight is its contraction, and
 * activates its area by that. Places are metres in the space of the mesh at rest.
 */
export interface MuscleDriver {
  type: 'muscle'
  name: string
  /** Absent: it moves the skin alone. */
  area?: string
  /** `linear`: a cone that converges on its origin; `sheet`: parallel fibres; `sphincter`: an ellipse that closes on its centre. */
  kind: 'linear' | 'sheet' | 'sphincter'
  /** Where it is fixed; a sphincter's centre. */
  origin: [number, number, number]
  /** Where it ends in the skin; the end of a sphincter's half-axis. */
  insertion: [number, number, number]
  /** Of a linear muscle: radians from its axis to the edge of its zone. */
  angle: number
  /** Metres: half a sheet's width, or a sphincter's other half-axis. */
  width: number
  /** Where the pull is strongest and where it ends, in shares of the distance from origin to insertion. */
  inner: number
  outer: number
  /** Share of the way to the origin that skin goes at full contraction. */
  strength: number
}

/** Activates an area by the person's age in years. */
export interface AgeDriver {
  type: 'age'
  area: string
  /** Points [years, activation]. */
  curve: Curve
}

/** Lets an area follow what drives it with a delay: skin creases quickly and relaxes slowly. */
export interface TimeDriver {
  type: 'time'
  area: string
  /** Seconds in which it makes up for 63% of what is missing, as it grows and as it fades. */
  attack: number
  release: number
}

/** A preset: blendshapes and activations by name. */
export interface ExpressionDriver {
  type: 'expression'
  name: string
  targets: { name: string; weight: number }[]
  /** For faces without other drivers. */
  activations: { area: string; activation: number }[]
}

/** Every type that this version plays. */
export const DRIVER_TYPES = [
  'morph',
  'area',
  'conflict',
  'bone',
  'tension',
  'muscle',
  'age',
  'time',
  'expression',
] as const satisfies readonly DriverType[]

interface Drivers {
  morph: MorphDriver
  area: AreaDriver
  conflict: ConflictDriver
  bone: BoneDriver
  tension: TensionDriver
  muscle: MuscleDriver
  age: AgeDriver
  time: TimeDriver
  expression: ExpressionDriver
}

export type DriverType = keyof Drivers
/** A driver of one type. */
export type DriverOf<T extends DriverType> = Drivers[T]

/** Drivers this version knows. Others are kept as they are, so that a later version's file survives. */
export type WrinkleDriver = Drivers[DriverType] | { type: string; [field: string]: unknown }

/** Whether this version plays a driver. */
export function isKnownDriver(driver: WrinkleDriver): driver is DriverOf<DriverType> {
  return (DRIVER_TYPES as readonly string[]).includes(driver.type)
}

/** The drivers of one type, in their order. */
export function driversOf<T extends DriverType>(type: T, drivers: readonly WrinkleDriver[]): DriverOf<T>[] {
  return drivers.filter((driver): driver is DriverOf<T> => driver.type === type)
}
