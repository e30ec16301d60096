import { join } from 'node:path'
import { AUTO_REGIONS, autoWrinkles, type Skin } from 'furrow/author'
import { findSkin } from 'furrow-files'
import { readDocument } from 'furrow-files/node'
import { noName, SCHEMES, type Spell, STAND_INS, swapSide } from './naming-schemes.ts'
import { spelled } from './rename.ts'

/** A blendshape that nearly all rigs have: the table shows its name. */
const EXAMPLE = 'mouthSmileLeft'

/** Gives each shape a name that tells nothing. */
function unnamed(): Spell {
  const shapes: string[] = []
  return (shape) => {
    if (!shapes.includes(shape)) shapes.push(shape)
    return noName(shapes.indexOf(shape))
  }
}

/** Rows of the table: how the names of a face's blendshapes are spelled. */
export const ROWS: Readonly<Record<string, Spell>> = {
  ARKit: (shape) => shape,
  ...SCHEMES,
  ...STAND_INS,
  'left and right swapped': swapSide,
  'no names': unnamed(),
}

/** The face that the rows rename: it has all of ARKit's shapes that move skin. */
export async function readFace(root: string): Promise<Skin> {
  const path = join(root, 'faces/human.glb')
  return findSkin(await readDocument(path, 'rig table'), path, 'rig table').skin
}

/** Makes a row: the rig, its name of a smile, the number of blendshapes, and which sides of each region get areas. */
export function rowOf(name: string, face: Skin): string {
  const spell = ROWS[name]!
  const skin = spelled(face, spell)
  const areas = autoWrinkles(skin, { size: 64, areaSize: 64 }).areas.map((area) => area.name)
  const cells = AUTO_REGIONS.map((region) => {
    const [first, second] = areas.filter((area) => area.replace(/(Left|Right)$/, '') === region)
    if (first === undefined) return '–'
    return first === region || second !== undefined ? 'yes' : first.slice(region.length).toLowerCase()
  })
  const example = spell(EXAMPLE) === undefined ? '–' : `\`${spell(EXAMPLE)}\``.replace('|', '\\|')
  return lineOf([name, example, String(skin.targets.length), ...cells])
}

/** The first two lines of the table. */
export const HEAD = [
  lineOf(['rig', `\`${EXAMPLE}\``, 'shapes', ...AUTO_REGIONS]),
  lineOf(Array.from({ length: AUTO_REGIONS.length + 3 }, () => '---')),
]

function lineOf(cells: readonly string[]): string {
  return `| ${cells.join(' | ')} |`
}
