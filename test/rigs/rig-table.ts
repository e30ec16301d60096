import { join } from 'node:path'
import { AUTO_REGIONS, autoWrinkles, type Skin } from 'furrow/author'
import { findSkin } from 'furrow-files'
import { readDocument } from 'furrow-files/node'
import { noName, SCHEMES, type Spell, STAND_INS, swapSide } from './naming-schemes.ts'
import { respelled } from './rename.ts'

/** Blendshape that nearly all rigs have; the table shows its name. */
const EXAMPLE = 'mouthSmileLeft'

/** Gives each shape a name without meaning. */
function unnamed(): Spell {
  const shapes: string[] = []
  return (shape) => {
    if (!shapes.includes(shape)) shapes.push(shape)
    return noName(shapes.indexOf(shape))
  }
}

/** Rows of the table: spellings of a face's blendshapes. */
export const ROWS: Readonly<Record<string, Spell>> = {
  ARKit: (shape) => shape,
  ...SCHEMES,
  ...STAND_INS,
  'left and right swapped': swapSide,
  'no names': unnamed(),
}

/** Reads the face that the rows rename. It has all of ARKit's shapes that move skin. */
export async function readFace(root: string): Promise<Skin> {
  const path = join(root, 'faces/human.glb')
  return findSkin(await readDocument(path, 'rig table'), path, 'rig table').skin
}

/** Makes a row: rig, name of a smile, number of blendshapes, and sides of each region that get areas. */
export function rowOf(name: string, face: Skin): string {
  const spell = ROWS[name]!
  const skin = respelled(face, spell)
  const areas = autoWrinkles(skin, { size: 64, areaSize: 64 }).areas.map((area) => area.name)
  const cells = AUTO_REGIONS.map((region) => {
    const [first, second] = areas.filter((area) => area.replace(/(Left|Right)$/, '') === region)
    if (first === undefined) return '–'
    return first === region || second !== undefined ? 'yes' : first.slice(region.length).toLowerCase()
  })
  const example = spell(EXAMPLE) === undefined ? '–' : `\`${spell(EXAMPLE)}\``.replace('|', '\\|')
  return lineOf([name, example, String(skin.targets.length), ...cells])
}

/** Header of the table. */
export const HEAD = [
  lineOf(['rig', `\`${EXAMPLE}\``, 'shapes', ...AUTO_REGIONS]),
  lineOf(Array.from({ length: AUTO_REGIONS.length + 3 }, () => '---')),
]

function lineOf(cells: readonly string[]): string {
  return `| ${cells.join(' | ')} |`
}
