import type { AreaDefinition } from 'furrow/author'
import type { AreaShape } from 'furrow/internal'
import type { StudioDocument } from './document.ts'
import { changed, kept } from './names.ts'

type Shapes = Pick<StudioDocument, 'strokeAreas'>

/** Renames an area in `strokeAreas` (area shapes from an imported `strokes.json`), and the group of strokes that has the same name. */
export function renameInShapes({ strokeAreas }: StudioDocument, name: string, newName: string): Shapes {
  if (!strokeAreas) return {}
  const rename = (shape: AreaShape): AreaShape =>
    'group' in shape && shape.group === name ? { ...shape, group: newName } : shape
  const renamed = changed(strokeAreas, (area): AreaDefinition => {
    const shapes = changed(area.shapes, rename) as AreaShape[]
    const within = area.within && rename(area.within)
    if (area.name !== name && shapes === area.shapes && within === area.within) return area
    return { name: area.name === name ? newName : area.name, shapes, ...(within && { within }) }
  })
  return { strokeAreas: renamed as AreaDefinition[] }
}

/** Removes the shapes of one area from `strokeAreas`. */
export function removeShapes(document: StudioDocument, name: string): Shapes {
  return filterShapes(document, (area) => area !== name)
}

/** Removes from `strokeAreas` the shapes of all areas that are not in `names`. */
export function shapesOf(document: StudioDocument, names: ReadonlySet<string>): Shapes {
  return filterShapes(document, (area) => names.has(area))
}

function filterShapes({ strokeAreas }: StudioDocument, isKept: (area: string) => boolean): Shapes {
  return strokeAreas ? { strokeAreas: kept(strokeAreas, ({ name }) => isKept(name)) as AreaDefinition[] } : {}
}
