import { AUTO_REGIONS, type AutoRegion, DENSE_REGIONS } from 'furrow/author'
import { AUTO_DENSITIES, type StudioArea, type StudioDocument } from '../document/document.ts'
import { depthOf, setDepth, setStrength, strengthOf } from '../document/region.ts'
import { splitSide } from '../document/sides.ts'
import { AUTOMATIC } from '../labels/automatic.ts'
import { CARD } from '../labels/stage.ts'
import { NumberSlider } from '../panels/controls/number-slider.tsx'
import type { PanelModel } from '../panels/model.ts'
import { Icon } from '../ui/icon.tsx'

/** Strength, depth, number of lines, other lines, and visibility of a region. */
export function RegionCard({ area: { name }, model }: { area: StudioArea; model: PanelModel }) {
  const { session, areas, auto, actions } = model
  const document = session.document.value!
  const [strength, depth] = [strengthOf(document, name), depthOf(document, name)]
  const edit = (label: string, change: (old: StudioDocument) => StudioDocument) =>
    actions.attempt(() => session.edit(`${label} of ${name}`, change, `${label} of ${name}`))
  const region = document.auto && regionOf(name)
  const dense = DENSE_REGIONS.find((each) => each === region)
  const density = (dense && auto.value.densities?.[dense]) ?? 1
  const withDensity = (density: number) => {
    const settings = auto.peek()
    return { ...settings, densities: { ...settings.densities, [dense!]: density } }
  }
  const isHidden = areas.muted.value.has(name)
  return (
    <>
      {strength !== undefined && (
        <NumberSlider
          label={CARD.strength}
          range={[0.02, 1, 0.02]}
          value={strength}
          onMove={(value) => edit('Strength', (old) => setStrength(old, name, value))}
          onRest={() => session.settle()}
        />
      )}
      {depth > 0 && (
        <NumberSlider
          label={CARD.depth}
          range={[0.02, 3, 0.02]}
          value={depth}
          onMove={(value) => edit('Depth', (old) => setDepth(old, name, value))}
          onRest={() => session.settle()}
        />
      )}
      {dense && (
        <NumberSlider
          label={CARD.density}
          range={[...AUTO_DENSITIES, 0.05]}
          value={density}
          text={`× ${density.toFixed(2)}`}
          onMove={(value) => actions.previewAuto(withDensity(value))}
          onRest={(value) => actions.makeAuto(withDensity(value))}
        />
      )}
      <div class="work">
        {region && (
          <button type="button" onClick={() => actions.makeAuto(shuffled(auto.peek(), region))}>
            {AUTOMATIC.shuffle}
          </button>
        )}
        <button type="button" aria-pressed={isHidden} onClick={() => areas.toggleMute(name)}>
          <Icon name="eye" /> {CARD.hide}
        </button>
      </div>
    </>
  )
}

/** Returns the region with seeds to which an area belongs, or undefined. The whole forehead shares one seed. */
function regionOf(area: string): AutoRegion | undefined {
  const [stem] = splitSide(area)
  const region = stem === 'foreheadOuter' ? 'foreheadInner' : stem
  return AUTO_REGIONS.find((each) => each === region)
}

/** Returns settings with a new seed for the lines of a region. */
function shuffled(settings: ReturnType<PanelModel['auto']['peek']>, region: AutoRegion) {
  const { seed = 0, seeds } = settings
  return { ...settings, seeds: { ...seeds, [region]: (seeds?.[region] ?? seed) + 1 } }
}
