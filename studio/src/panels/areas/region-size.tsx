import { useId } from 'preact/hooks'
import { AREA_SIZES, areaCost } from '../../document/area-size.ts'
import { PLACES } from '../../labels/page.ts'
import { REGION, regionCostLabel, sizeLabel } from '../../labels/regions.ts'
import { Section } from '../controls/section.tsx'
import type { PanelModel } from '../model.ts'

/** Choice of the width and height of all regions, with its cost. */
export function RegionSize({ model: { session, areas } }: { model: PanelModel }) {
  const id = useId()
  const document = session.document.value
  if (!document) return null
  // Files and folders can have other sizes.
  const sizes = [...new Set([...AREA_SIZES, document.areaSize])].sort((a, b) => a - b)
  return (
    <Section title={PLACES.advanced}>
      <div class="settings">
        <div class="setting">
          <label for={id}>{REGION.size}</label>
          <select
            id={id}
            value={document.areaSize}
            onChange={({ currentTarget }) => areas.resize(Number(currentTarget.value))}
          >
            {sizes.map((size) => (
              <option key={size} value={size}>
                {sizeLabel(size)}
              </option>
            ))}
          </select>
        </div>
      </div>
      <p class="hint">{regionCostLabel(areaCost(document))}</p>
    </Section>
  )
}
