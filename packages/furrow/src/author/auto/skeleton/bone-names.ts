/** Part of a humanoid that a joint moves. */
export type BodyPart = 'head' | 'neck' | 'hand' | 'upperArm' | 'thigh' | Hinge | Finger

/** Joint that bends a limb: the joint of the forearm, or of the lower leg. */
export type Hinge = 'elbow' | 'knee'

export const FINGERS = ['thumb', 'index', 'middle', 'ring', 'little'] as const
export type Finger = (typeof FINGERS)[number]

/** Side of the body; undefined if the name does not tell. */
export type BodySide = 'left' | 'right' | undefined

export interface BoneName {
  part: BodyPart
  side: BodySide
}

/** Joints that help to deform or control a limb, end a chain, or lie inside the palm. */
const HELPERS =
  /twist|roll|end|tip|nub|ik|pole|ctrl|target|helper|half|metacarpal|palm|socket|attach|weapon|holster/

/** Words for each part in the names of rigs, tried in this order. Words are matched without digits, sides and separators. */
const PARTS: readonly (readonly [part: BodyPart, words: RegExp])[] = [
  ['thumb', /thumb/],
  ['index', /index|pointer|forefinger/],
  ['middle', /mid(dle)?(finger|proximal|intermediate|distal|phalanx|$)|^f?hand?mid/],
  ['ring', /^(hand|def|org|ccbase|bip)*ring(finger|$|proximal|intermediate|distal)/],
  ['little', /little|pinky|pinkie/],
  ['hand', /^(bip|ccbase|def|org)*(hand|wrist)$/],
  ['upperArm', /^(bip|ccbase|def|org|mch)*(upperarm|arm)$/],
  ['thigh', /^(bip|ccbase|def|org|mch)*(upperleg|upleg|thigh)$/],
  ['elbow', /^(bip|ccbase|def|org|mch)*(lowerarm|forearm|elbow)$/],
  ['knee', /^(bip|ccbase|def|org|mch)*(lowerleg|shin|calf|knee|leg)$/],
  ['neck', /^(bip|ccbase|def|org)*neck$/],
  ['head', /^(bip|ccbase|def|org)*head$/],
]

/** Fingers of MakeHuman, where finger 1 is the thumb. */
const NUMBERED = /finger(\d)[-_.]\d/i

/** Joints of Rigify's spine that belong to the neck and the head. */
const RIGIFY: Readonly<Record<string, BodyPart>> = { '004': 'neck', '005': 'neck', '006': 'head' }

/**
 * Recognises a joint by its name in the rigs of VRM and VRoid, Mixamo, Ready Player Me, Rigify, Unreal, MakeHuman, Character Creator and
 * WebXR.
 *
 * @returns undefined if the joint is unknown or only helps to deform a limb.
 */
export function boneNameOf(name: string): BoneName | undefined {
  const words = wordsOf(name)
  const side = sideOf(words)
  const numbered = NUMBERED.exec(name)
  if (numbered) {
    const finger = FINGERS[Number(numbered[1]) - 1]
    return finger && { part: finger, side }
  }
  const rigify = /(?:^|-)spine\.(00\d)$/.exec(name)
  if (rigify) return RIGIFY[rigify[1]] && { part: RIGIFY[rigify[1]], side }
  const text = words.filter((word) => !SIDES.has(word) && !/^\d+$/.test(word)).join('')
  // The metacarpal of a thumb moves it, and Character Creator calls the joints of the neck twists.
  const own = text.replace('thumbmetacarpal', 'thumb').replace('necktwist', 'neck')
  if (HELPERS.test(own)) return undefined
  const found = PARTS.find(([, pattern]) => pattern.test(own))
  return found && { part: found[0], side }
}

const SIDES = new Map<string, BodySide>([
  ['l', 'left'],
  ['left', 'left'],
  ['r', 'right'],
  ['right', 'right'],
])

function sideOf(words: readonly string[]): BodySide {
  return words.map((word) => SIDES.get(word)).find((side) => side !== undefined)
}

/** Splits a name into lower-case words. Drops namespaces such as `mixamorig:` and VRoid's prefix `J_Bip`. */
function wordsOf(name: string): string[] {
  return name
    .replace(/^.*[:|]/, '')
    .replace(/^mixamorig\d*_?/i, '')
    .replace(/^J_(Bip|Sec|Adj)_/, '')
    .replace(/([a-z])([A-Z])/g, '$1 $2')
    .replace(/(\d+)/g, ' $1 ')
    .toLowerCase()
    .split(/[^\p{L}\d]+/u)
    .filter((word) => word !== '' && word !== 'f' && word !== 'c')
}
