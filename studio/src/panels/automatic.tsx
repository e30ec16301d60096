import { AUTO_DEFAULTS, AUTO_REGIONS, type AutoRegion } from 'furrow/author'
import {
  AUTO_AGES,
  AUTO_SIZES,
  AUTO_STRENGTHS,
  AUTO_SYMMETRIES,
  type AutoSettings,
} from '../document/document.ts'
import { AUTOMATIC } from '../labels/automatic.ts'
import { regionName } from '../labels/names.ts'
import { sizeLabel } from '../labels/regions.ts'
import { autoSource } from '../open/surface.ts'
import { FileButton } from './controls/file-button.tsx'
import { NumberSlider } from './controls/number-slider.tsx'
import type { PanelModel } from './model.ts'
import { SurfaceChoice } from './surface.tsx'

/** Settings of automatic wrinkles. While a slider moves, the face shows previews. On release, the complete wrinkles are made. */
export function AutomaticWrinkles({ model }: { model: PanelModel }) {
  const { auto, source, actions } = model
  const settings = auto.value
  // Regions and the symmetry of both sides belong to faces.
  const hasShapes = (source.value?.skin.targets.length ?? 0) > 0
  const made = source.value && autoSource(source.value, settings)
  if (!made) return <SurfaceChoice model={model} />
  const make = (change: Partial<AutoSettings>) => actions.makeAuto({ ...settings, ...change })
  const slider = (
    name: 'age' | 'strength' | 'symmetry',
    [low, high]: readonly [low: number, high: number],
    step: number,
  ) => (
    <NumberSlider
      label={AUTOMATIC[name]}
      range={[low, high, step]}
      value={settings[name] ?? AUTO_DEFAULTS[name]}
      onMove={(value) => actions.previewAuto({ ...settings, [name]: value })}
      onRest={(value) => make({ [name]: value })}
    />
  )
  return (
    <div class="settings-group">
      <SurfaceChoice model={model} />
      {made.options.cloth === undefined && slider('age', AUTO_AGES, 1)}
      {slider('strength', AUTO_STRENGTHS, 0.05)}
      {hasShapes && slider('symmetry', AUTO_SYMMETRIES, 0.05)}
      <div class="settings">
        <div class="setting">
          <label for="map-size">{AUTOMATIC.size}</label>
          <select
            id="map-size"
            value={settings.size}
            onChange={({ currentTarget }) => make({ size: Number(currentTarget.value) })}
          >
            {AUTO_SIZES.map((size) => (
              <option key={size} value={size}>
                {sizeLabel(size)}
              </option>
            ))}
          </select>
        </div>
      </div>
      <button type="button" onClick={() => make({ seed: (settings.seed ?? 0) + 1, seeds: {} })}>
        {AUTOMATIC.shuffle}
      </button>
      {hasShapes && (
        <Regions
          chosen={settings.regions ?? AUTO_REGIONS}
          onChange={(regions) => {
            const { regions: _, ...others } = settings
            actions.makeAuto(regions.length === AUTO_REGIONS.length ? others : { ...others, regions })
          }}
        />
      )}
      <div class="work">
        <button type="button" onClick={actions.savePreset}>
          {AUTOMATIC.savePreset}
        </button>
        <FileButton accept=".json" onChoose={actions.openFiles}>
          {AUTOMATIC.applyPreset}
        </FileButton>
      </div>
    </div>
  )
}

interface RegionsProps {
  chosen: readonly AutoRegion[]
  onChange(regions: AutoRegion[]): void
}

function Regions({ chosen, onChange }: RegionsProps) {
  return (
    <fieldset class="chips">
      <legend>{AUTOMATIC.regions}</legend>
      {AUTO_REGIONS.map((region) => (
        <label key={region}>
          <input
            type="checkbox"
            checked={chosen.includes(region)}
            onChange={({ currentTarget: { checked } }) => {
              onChange(AUTO_REGIONS.filter((each) => (each === region ? checked : chosen.includes(each))))
            }}
          />
          <span title={region}>{regionName(region)}</span>
        </label>
      ))}
    </fieldset>
  )
}
