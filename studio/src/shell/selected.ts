import type { StudioArea } from '../document/document.ts'
import { lineLabel, linesLabel } from '../labels/lines.ts'
import { regionLabel } from '../labels/names.ts'
import { PLACES, wholeLabel } from '../labels/page.ts'
import type { PanelModel } from '../panels/model.ts'

/** Selection that the inspector shows. */
export interface Selected {
  readonly kind: 'whole' | 'region' | 'line' | 'new line'
  readonly label: string
  /** Name in the file, beside the label. */
  readonly fileName?: string
  readonly area?: StudioArea
  /** Group of the line. */
  readonly group?: string
  /** Layer of the region or the line. */
  readonly layer?: string
}

/** Returns the selection. A line has precedence over a region. */
export function selectedIn(model: PanelModel): Selected {
  const { lines, areas, tools } = model
  const line = lines.chosen.value
  if (line) {
    const { group, layer } = line
    const count = lines.allChosen.value.length
    if (count > 1)
      return { kind: 'line', label: linesLabel(count), layer, ...(group !== undefined && { group }) }
    const label = lineLabel(group)
    return { kind: 'line', label, layer, ...(group !== undefined && { group, fileName: group }) }
  }
  if (tools.tool.value === 'draw') return { kind: 'new line', label: PLACES.newLine }
  const area = areas.chosen.value
  if (area && tools.mode.value !== 'lines') {
    const { name, layer } = area
    return { kind: 'region', label: regionLabel(name), fileName: name, area, layer }
  }
  return { kind: 'whole', label: tools.mode.value === 'lines' ? PLACES.lines : wholeOf(model) }
}

/** Returns the label for no selection. */
export function wholeOf({ viewer }: Pick<PanelModel, 'viewer'>): string {
  const { skins, skin } = viewer.value?.avatar ?? {}
  return wholeLabel(skin !== undefined && skins![skin].blendshapes > 0)
}
