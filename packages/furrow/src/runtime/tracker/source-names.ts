import { both, EXPRESSIONS } from '../../drivers/expression/presets.ts'
import { canonicalTargetName } from '../../drivers/morph/target-names.ts'

/** Names of values other than blendshapes: MediaPipe's score of a neutral face, VRM's neutral face, and the rotations of Live Link Face. */
const IGNORED = /^(_neutral|neutral|(Head|LeftEye|RightEye)(Yaw|Pitch|Roll))$/i

/** Short names: Oculus visemes without a prefix, and presets of VRM 0 that differ from VRM 1.0 by more than `ALIASES` covers. */
const SHORT_NAMES: Readonly<Record<string, string>> = {
  sil: 'viseme_sil',
  PP: 'viseme_PP',
  FF: 'viseme_FF',
  TH: 'viseme_TH',
  DD: 'viseme_DD',
  kk: 'viseme_kk',
  CH: 'viseme_CH',
  SS: 'viseme_SS',
  nn: 'viseme_nn',
  RR: 'viseme_RR',
  A: 'viseme_aa',
  I: 'viseme_I',
  U: 'viseme_U',
  E: 'viseme_E',
  O: 'viseme_O',
  LookUp: 'lookUp',
  LookDown: 'lookDown',
  LookLeft: 'lookLeft',
  LookRight: 'lookRight',
}

/** Blendshapes with factors: `up` follows positive scores, `down` follows negative scores. */
export interface ShapeMix {
  readonly up: Readonly<Record<string, number>>
  readonly down?: Readonly<Record<string, number>>
}

/** Returns the visemes of Oculus as ARKit blendshapes, by the position of jaw and lips for each sound. */
const visemes = (): Record<string, Record<string, number>> => ({
  viseme_sil: {},
  viseme_PP: { ...both('mouthPress', 0.5), mouthRollLower: 0.3, mouthRollUpper: 0.3 },
  viseme_FF: { ...both('mouthUpperUp', 0.2), mouthRollLower: 0.6, jawOpen: 0.05 },
  viseme_TH: { jawOpen: 0.15, tongueOut: 0.3 },
  viseme_DD: { ...both('mouthLowerDown', 0.2), jawOpen: 0.15 },
  viseme_kk: { ...both('mouthStretch', 0.1), jawOpen: 0.2 },
  viseme_CH: { mouthFunnel: 0.5, jawOpen: 0.1 },
  viseme_SS: { ...both('mouthStretch', 0.4), jawOpen: 0.05 },
  viseme_nn: { jawOpen: 0.12 },
  viseme_RR: { mouthFunnel: 0.3, jawOpen: 0.1 },
  viseme_aa: { jawOpen: 0.6 },
  viseme_E: { ...both('mouthStretch', 0.3), jawOpen: 0.3 },
  viseme_I: { ...both('mouthSmile', 0.2), ...both('mouthStretch', 0.4), jawOpen: 0.15 },
  viseme_O: { mouthFunnel: 0.6, jawOpen: 0.4 },
  viseme_U: { mouthPucker: 0.7, jawOpen: 0.15 },
})

/**
 * Features of OpenSeeFace, each -1..1 with 0 at rest, as `Unity/OpenSee.cs` describes them
 * (https://github.com/emilianavt/OpenSeeFace/blob/bc74658196e7be9c1de12300a3f8a6507e47b8bf/Unity/OpenSee.cs). The description does not tell the
 * direction of the features without blendshapes.
 */
function openSeeFeatures(side: 'Left' | 'Right'): Record<string, ShapeMix> {
  const one = (name: string, factor = 1) => ({ [`${name}${side}`]: factor })
  return {
    [`Eye${side}`]: { up: one('eyeWide'), down: one('eyeBlink') },
    [`EyebrowUpDown${side}`]: { up: { ...one('browOuterUp'), browInnerUp: 0.5 }, down: one('browDown') },
    [`EyebrowSteepness${side}`]: { up: {} },
    [`EyebrowQuirk${side}`]: { up: {} },
    [`MouthCornerUpDown${side}`]: { up: one('mouthSmile'), down: one('mouthFrown') },
    [`MouthCornerInOut${side}`]: { up: {} },
  }
}

/** Returns replacements for scores of shapes that a face lacks, by canonical name. */
function allMixes(): Record<string, ShapeMix> {
  return {
    ...Object.fromEntries(Object.entries(visemes()).map(([name, up]) => [name, { up }])),
    ...openSeeFeatures('Left'),
    ...openSeeFeatures('Right'),
    MouthOpen: { up: { jawOpen: 1 } },
    MouthWide: { up: both('mouthStretch', 0.5), down: { mouthPucker: 0.7 } },
    // Presets of VRM for faces with ARKit blendshapes.
    ...Object.fromEntries(EXPRESSIONS.map(({ name, targets }) => [name, { up: targets }])),
    lookUp: { up: both('eyeLookUp') },
    lookDown: { up: both('eyeLookDown') },
    lookLeft: { up: { eyeLookOutLeft: 1, eyeLookInRight: 1 } },
    lookRight: { up: { eyeLookInLeft: 1, eyeLookOutRight: 1 } },
    relaxed: { up: { ...both('mouthSmile', 0.4), ...both('cheekSquint', 0.3) } },
    blink: { up: both('eyeBlink') },
    blinkLeft: { up: { eyeBlinkLeft: 1 } },
    blinkRight: { up: { eyeBlinkRight: 1 } },
    // ARKit blendshapes for faces with the presets of VRM.
    eyeBlinkLeft: { up: { blinkLeft: 1 } },
    eyeBlinkRight: { up: { blinkRight: 1 } },
    jawOpen: { up: { viseme_aa: 1 } },
    mouthFunnel: { up: { viseme_O: 1 } },
    mouthPucker: { up: { viseme_U: 1 } },
  }
}

/** Table of all mixes, created at the first lookup, so that pages without a tracker do not download it. */
let mixes: ReadonlyMap<string, ShapeMix> | undefined

/** Returns possible canonical names of a score's blendshape, preferred first. The list is empty if the score does not belong to a blendshape. */
export function shapesOfScore(name: string): readonly string[] {
  if (IGNORED.test(name)) return []
  // A face can have a blendshape with the short name.
  if (Object.hasOwn(SHORT_NAMES, name)) return [name, SHORT_NAMES[name]]
  return [mixOf(name) ? name : canonicalTargetName(name)]
}

/** Returns blendshapes that replace a canonical blendshape on a face that lacks it. */
export function mixOf(shape: string): ShapeMix | undefined {
  mixes ??= new Map(Object.entries(allMixes()))
  return mixes.get(shape)
}
