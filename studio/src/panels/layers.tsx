import { MAX_BLOOD_AMPLITUDE } from 'furrow/internal'
import { useId, useRef } from 'preact/hooks'
import { MAP_NAMES, type MapName, type StudioLayer } from '../document/document.ts'
import { LAYER, layerLabels, MAPS, mapLabels } from '../labels/layers.ts'
import { PLACES } from '../labels/page.ts'
import type { LayerEditor } from '../session/layer-editor.ts'
import { Choice } from './controls/choice.tsx'
import { FileButton } from './controls/file-button.tsx'
import { NumberSlider } from './controls/number-slider.tsx'
import { Section } from './controls/section.tsx'
import { TextField } from './controls/text-field.tsx'
import type { PanelModel } from './model.ts'

const KINDS = [
  { value: 'detail', label: LAYER.detail, title: LAYER.detailHint },
  { value: 'replace', label: LAYER.replace, title: LAYER.replaceHint },
] as const

const IMAGES = 'image/png,image/jpeg,image/webp'
const SCULPTS = '.glb,.gltf,.vrm'

interface LayersProps {
  model: PanelModel
  /** Layer of the selection, which is unfolded. */
  shown: string | undefined
}

/** Layers with their maps. */
export function Layers({ model: { layers, session, actions }, shown }: LayersProps) {
  const document = session.document.value
  const keys = useKeys(document?.layers.map(({ name }) => name) ?? [])
  if (!document) return null
  return (
    <Section title={PLACES.layers}>
      {document.layers.map((layer, i) => (
        <Layer
          key={keys[i]}
          layer={layer}
          isShown={layer.name === shown}
          isFirst={i === 0}
          isLast={i === document.layers.length - 1}
          hasStrokes={document.strokes.some((stroke) => stroke.layer === layer.name)}
          editor={layers}
          attempt={actions.attempt}
        />
      ))}
      <div class="add">
        <button type="button" onClick={() => layers.add()}>
          {LAYER.add}
        </button>
        <button type="button" title={LAYER.saveMapsHint} onClick={() => layers.save()}>
          {LAYER.saveMaps}
        </button>
        <button type="button" title={LAYER.saveUvsHint} onClick={actions.saveUvLayout}>
          {LAYER.saveUvs}
        </button>
      </div>
    </Section>
  )
}

/** Returns a key for each layer. A layer keeps its key when it is renamed, so that its form keeps the focus. */
function useKeys(names: readonly string[]): readonly number[] {
  const last = useRef({ names, keys: names.map((_, i) => i), free: names.length })
  const { names: old, keys, free } = last.current
  const isRenamed = names.length === old.length && names.filter((name) => !old.includes(name)).length === 1
  const next = names.map((name, i) => keys[isRenamed ? i : old.indexOf(name)] ?? free + i)
  last.current = { names, keys: next, free: Math.max(free, ...next.map((key) => key + 1)) }
  return next
}

interface LayerProps {
  layer: StudioLayer
  isShown: boolean
  isFirst: boolean
  isLast: boolean
  hasStrokes: boolean
  editor: LayerEditor
  /** Runs a task and shows its errors. */
  attempt(task: () => unknown): void
}

function Layer({ layer, isShown, isFirst, isLast, hasStrokes, editor, attempt }: LayerProps) {
  const { name, kind, normalScale, maps, heightAmplitude, bloodAmplitude, onsetStrength, isOnsetDrawn } =
    layer
  const { sculpted } = layer
  const labels = layerLabels(name)
  return (
    <details class="layer" open={isShown}>
      <summary>
        {name}
        <span>{kind}</span>
      </summary>
      <div class="settings">
        <TextField
          label={LAYER.name}
          fullLabel={labels.name}
          value={name}
          onChange={(next) => editor.rename(name, next)}
        />
        <Choice
          label={LAYER.kind}
          options={KINDS}
          value={kind}
          onChange={(value) => editor.set(name, { kind: value })}
        />
        <NumberSlider
          label={LAYER.scale}
          range={[0, 2, 0.05]}
          value={normalScale}
          onMove={(value) => editor.set(name, { normalScale: value })}
          onRest={() => editor.settle()}
        />
        {maps.height && (
          <NumberSlider
            label={LAYER.height}
            range={[0, 10, 0.1]}
            value={1000 * (heightAmplitude ?? 0)}
            onMove={(value) => editor.set(name, { heightAmplitude: value / 1000 })}
            onRest={() => editor.settle()}
          />
        )}
        {maps.blood && (
          <NumberSlider
            label={LAYER.blood}
            range={[0, MAX_BLOOD_AMPLITUDE, 0.05]}
            value={bloodAmplitude ?? 0}
            onMove={(value) => editor.set(name, { bloodAmplitude: value })}
            onRest={() => editor.settle()}
          />
        )}
        {(maps.onset || isOnsetDrawn) && (
          <NumberSlider
            label={LAYER.onset}
            range={[0, 1, 0.05]}
            value={onsetStrength ?? 1}
            onMove={(value) => editor.set(name, { onsetStrength: value })}
            onRest={() => editor.settle()}
          />
        )}
      </div>
      {MAP_NAMES.map((map) => (
        <MapRow
          key={map}
          layer={layer}
          map={map}
          isDrawn={hasStrokes && isDrawn(map, layer)}
          editor={editor}
          attempt={attempt}
        />
      ))}
      {sculpted && (
        <div class="map">
          <span class="label">{LAYER.sculpted}</span>
          <button type="button" onClick={() => editor.resetSculpted(name)}>
            {LAYER.resetSculpted}
          </button>
        </div>
      )}
      <Bake name={name} editor={editor} />
      <div class="add">
        <button
          type="button"
          aria-disabled={isFirst}
          aria-label={labels.up}
          onClick={() => editor.move(name, -1)}
        >
          {LAYER.up}
        </button>
        <button
          type="button"
          aria-disabled={isLast}
          aria-label={labels.down}
          onClick={() => editor.move(name, 1)}
        >
          {LAYER.down}
        </button>
        <button type="button" aria-label={labels.remove} onClick={() => editor.remove(name)}>
          {LAYER.remove}
        </button>
      </div>
    </details>
  )
}

/** Whether strokes are drawn into a map. */
function isDrawn(map: MapName, { isOnsetDrawn }: StudioLayer): boolean {
  return map === 'normal' || map === 'occlusion' || (map === 'onset' && isOnsetDrawn === true)
}

interface MapRowProps extends Pick<LayerProps, 'layer' | 'editor' | 'attempt'> {
  map: MapName
  isDrawn: boolean
}

function MapRow({ layer: { name, maps }, map, isDrawn, editor, attempt }: MapRowProps) {
  const labels = mapLabels(map, name)
  const hasImage = maps[map] !== undefined
  return (
    <div class="map">
      <span class="label">{MAPS[map]}</span>
      <span class="hint">{sourceLabel(hasImage, isDrawn)}</span>
      <FileButton
        label={labels.import}
        title={labels.importHint}
        accept={IMAGES}
        onChoose={([file]) => attempt(() => editor.importMap(name, map, file))}
      >
        {LAYER.import}
      </FileButton>
      <button
        type="button"
        disabled={!hasImage && !isDrawn}
        aria-label={labels.save}
        onClick={() => editor.saveMap(name, map)}
      >
        {LAYER.save}
      </button>
      <button
        type="button"
        class="remove"
        disabled={!hasImage}
        title={LAYER.remove}
        aria-label={labels.remove}
        onClick={() => editor.removeMap(name, map)}
      >
        ×
      </button>
    </div>
  )
}

/** Returns what a map is made from. */
function sourceLabel(hasImage: boolean, isDrawn: boolean): string {
  if (hasImage) return isDrawn ? LAYER.imageAndLines : LAYER.image
  return isDrawn ? LAYER.lines : LAYER.none
}

/** Button that bakes a sculpt, which the user chooses or drops, into a normal map. Shows the progress. */
function Bake({ name, editor }: { name: string; editor: LayerEditor }) {
  const id = useId()
  const run = editor.run.value
  if (run?.layer === name) {
    return (
      <div class="run">
        <label for={id}>{LAYER.baking}</label>
        <progress id={id} max="1" value={run.fraction} />
        <button type="button" class="quiet" onClick={() => editor.cancelBake()}>
          {LAYER.cancel}
        </button>
      </div>
    )
  }
  return (
    <FileButton
      label={layerLabels(name).bake}
      title={LAYER.bakeHint}
      accept={SCULPTS}
      isDropTarget
      onChoose={([file]) => editor.bake(name, file)}
    >
      {LAYER.bake}
    </FileButton>
  )
}
