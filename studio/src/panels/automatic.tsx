import { AUTO_DEFAULTS, AUTO_REGIONS, type AutoRegion } from 'furrow/author'
import { useState } from 'preact/hooks'
import {
  AUTO_AGES,
  AUTO_SIZES,
  AUTO_STRENGTHS,
  AUTO_SYMMETRIES,
  type AutoSettings,
} from '../document/document.ts'
import { AutoProgress } from './auto-progress.tsx'
import { NumberSlider } from './controls/number-slider.tsx'
import { Section } from './controls/section.tsx'
import type { PanelModel } from './model.ts'

/** Settings of automatic wrinkles. While a slider moves, the face shows previews. On release, the complete wrinkles are made. */
export function AutomaticWrinkles({ model }: { model: PanelModel }) {
  const { auto, actions } = model
  const settings = auto.value
  const make = (change: Partial<AutoSettings>) => actions.makeAuto({ ...settings, ...change })
  const [lines, setLines] = useState<Lines>('all')
  const preview = (change: Partial<AutoSettings>) => actions.previewAuto({ ...settings, ...change })
  return (
    <Section title="Automatic wrinkles">
      <NumberSlider
        label="Age"
        range={[...AUTO_AGES, 1]}
        value={settings.age ?? AUTO_DEFAULTS.age}
        onMove={(age) => preview({ age })}
        onRest={(age) => make({ age })}
      />
      <NumberSlider
        label="Strength"
        range={[...AUTO_STRENGTHS, 0.05]}
        value={settings.strength}
        onMove={(strength) => preview({ strength })}
        onRest={(strength) => make({ strength })}
      />
      <NumberSlider
        label="Symmetry"
        range={[...AUTO_SYMMETRIES, 0.05]}
        value={settings.symmetry ?? AUTO_DEFAULTS.symmetry}
        onMove={(symmetry) => preview({ symmetry })}
        onRest={(symmetry) => make({ symmetry })}
      />
      <div class="settings">
        <div class="setting">
          <label for="map-size">Size</label>
          <select
            id="map-size"
            value={settings.size}
            onChange={({ currentTarget }) => make({ size: Number(currentTarget.value) })}
          >
            {AUTO_SIZES.map((size) => (
              <option key={size} value={size}>
                {size} x {size}
              </option>
            ))}
          </select>
        </div>
        <div class="setting">
          <label for="other-lines">Lines of</label>
          <span class="with-button">
            <select
              id="other-lines"
              value={lines}
              onChange={({ currentTarget }) => setLines(currentTarget.value as Lines)}
            >
              <option value="all">all regions</option>
              {WITH_LINES.map((region) => (
                <option key={region} value={region}>
                  {region === 'foreheadInner' ? 'forehead' : region}
                </option>
              ))}
            </select>
            <button type="button" onClick={() => make(otherLines(settings, lines))}>
              Draw others
            </button>
          </span>
        </div>
      </div>
      <Regions
        chosen={settings.regions ?? AUTO_REGIONS}
        onChange={(regions) => {
          const { regions: _, ...others } = settings
          actions.makeAuto(regions.length === AUTO_REGIONS.length ? others : { ...others, regions })
        }}
      />
      <AutoProgress model={model} />
    </Section>
  )
}

/** Region of the face to which a new seed applies, or all regions. */
type Lines = AutoRegion | 'all'

/** Regions that have seeds. The outer forehead has none, because it shares the lines of the inner forehead. */
const WITH_LINES = AUTO_REGIONS.filter((region) => region !== 'foreheadOuter')

/** Returns settings with a new seed for the wrinkle lines of a region, or of all regions. */
function otherLines({ seed = 0, seeds }: AutoSettings, lines: Lines): Partial<AutoSettings> {
  if (lines === 'all') return { seed: seed + 1, seeds: {} }
  return { seeds: { ...seeds, [lines]: (seeds?.[lines] ?? seed) + 1 } }
}

interface RegionsProps {
  chosen: readonly AutoRegion[]
  onChange(regions: AutoRegion[]): void
}

function Regions({ chosen, onChange }: RegionsProps) {
  return (
    <fieldset class="chips">
      <legend>Regions</legend>
      {AUTO_REGIONS.map((region) => (
        <label key={region}>
          <input
            type="checkbox"
            checked={chosen.includes(region)}
            onChange={({ currentTarget: { checked } }) => {
              onChange(AUTO_REGIONS.filter((each) => (each === region ? checked : chosen.includes(each))))
            }}
          />
          <span>{region}</span>
        </label>
      ))}
    </fieldset>
  )
}
