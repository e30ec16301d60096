import { join } from 'node:path'
import { autoWrinkles, type Skin } from 'furrow/author'
import { LINE_REGIONS } from 'furrow/internal'
import { skinAt } from '../skin-at.ts'
import { FEWER_SHAPES, type NamingScheme, noName, SCHEMES, swapSide } from './naming-schemes.ts'
import { withNamesOf } from './rename.ts'

/** Blendshape that nearly all rigs have. The table shows its name in each rig. */
const EXAMPLE = 'mouthSmileLeft'

/** Returns a naming scheme of meaningless, numbered names. */
function unnamed(): NamingScheme {
  const shapes: string[] = []
  return (shape) => {
    if (!shapes.includes(shape)) shapes.push(shape)
    return noName(shapes.indexOf(shape))
  }
}

/** Rows of the table in the documentation: naming schemes of blendshapes, by name of the rig. */
export const ROWS: Readonly<Record<string, NamingScheme>> = {
  ARKit: (shape) => shape,
  ...SCHEMES,
  ...FEWER_SHAPES,
  'left and right swapped': swapSide,
  'no names': unnamed(),
}

/** Reads the face whose blendshapes each row renames. It has all of ARKit's blendshapes that move skin. */
export async function readFace(root: string): Promise<Skin> {
  return skinAt(join(root, 'faces/human.glb'))
}

/** Makes a row: rig, its name for `EXAMPLE`, number of blendshapes, and, for each region, the sides on which automatic wrinkles made areas. */
export function rowOf(name: string, face: Skin): string {
  const scheme = ROWS[name]!
  const skin = withNamesOf(face, scheme)
  const areas = autoWrinkles(skin, { size: 64, areaSize: 64 }).areas.map((area) => area.name)
  const cells = LINE_REGIONS.map((region) => {
    const [first, second] = areas.filter((area) => area.replace(/(Left|Right)$/, '') === region)
    if (first === undefined) return '–'
    return first === region || second !== undefined ? 'yes' : first.slice(region.length).toLowerCase()
  })
  const example = scheme(EXAMPLE) === undefined ? '–' : `\`${scheme(EXAMPLE)}\``.replace('|', '\\|')
  return lineOf([name, example, String(skin.targets.length), ...cells])
}

export const HEAD = [
  lineOf(['rig', `\`${EXAMPLE}\``, 'shapes', ...LINE_REGIONS]),
  lineOf(Array.from({ length: LINE_REGIONS.length + 3 }, () => '---')),
]

function lineOf(cells: readonly string[]): string {
  return `| ${cells.join(' | ')} |`
}
