import { BANK_WIDTHS, isBulge } from 'furrow/internal'
import { useId } from 'preact/hooks'
import { LINE } from '../labels/lines.ts'
import { type LineEditor, type LineMode, REACH_RANGE } from '../lines/line-editor.ts'
import { type LineShape, meanTaper } from '../lines/line-shape.ts'
import { NumberSlider } from './controls/number-slider.tsx'
import { LineChoice, LinePoints } from './line-choice.tsx'
import type { PanelModel } from './model.ts'

/** Settings of the chosen wrinkle line, or of new lines. */
export function Lines({ model }: { model: PanelModel }) {
  const { lines, session, actions } = model
  const isNew = lines.mode.value === 'draw' && !lines.chosen.value
  const chosen = lines.chosen.value
  const shape = isNew ? lines.shape.value : chosen
  return (
    <div class="settings">
      {!isNew && <LineChoice editor={lines} strokes={session.document.value?.strokes ?? []} />}
      <p class="hint">{hintOf(lines)}</p>
      {lines.mode.value === 'edit' && (
        <NumberSlider
          label={LINE.reach}
          range={[...REACH_RANGE, 0.5]}
          value={lines.reach.value}
          text={lines.reach.value.toFixed(1)}
          onMove={(reach) => {
            lines.reach.value = reach
          }}
        />
      )}
      {chosen && <LinePoints editor={lines} actions={actions} />}
      {shape && (
        <>
          <Shape shape={shape} editor={lines} attempt={actions.attempt} />
          <Membership
            group={isNew ? lines.group.value : (chosen?.group ?? '')}
            layer={isNew ? lines.layer.value : (chosen?.layer ?? '')}
            isNew={isNew}
            groups={groupsOf(session)}
            layers={session.document.value?.layers.map(({ name }) => name) ?? []}
            editor={lines}
            attempt={actions.attempt}
          />
        </>
      )}
      {chosen && <Operations editor={lines} attempt={actions.attempt} />}
    </div>
  )
}

function hintOf({ mode, chosen, handles }: LineEditor): string {
  if (mode.value !== 'edit' || !chosen.value) return HINTS[mode.value]
  return handles.value.some(({ fork }) => fork) ? `${HINTS.chosen} ${HINTS.fork}` : HINTS.chosen
}

const HINTS: Record<LineMode | 'chosen' | 'fork', string> = {
  off: 'Every wrinkle is a line.',
  select: 'Drag across the line to make it deeper. Shift+click chooses several lines.',
  edit: 'Drag a line on the face, or choose one above. Shift+click chooses several lines.',
  chosen:
    'Drag the line or a point. Points within the reach follow. The keys [ and ] change the reach; with Alt, a point moves alone. Shift+click or double-click adds a point, Delete removes it.',
  fork: 'A diamond is a fork: dragging it moves all lines that meet there.',
  draw: 'Draw on the skin. Drag beside the face to turn it.',
  smooth: 'Click a line, or drag over lines, to smooth them.',
  erase: 'Click a line, or drag over lines, to delete them.',
}

type Attempt = PanelModel['actions']['attempt']

interface ControlsProps {
  editor: LineEditor
  attempt: Attempt
}

/** Minimum, maximum and step of each slider. Width and depth are in millimetres. A negative depth is the height of a bulge. */
const WIDTH = [0.2, 12, 0.1] as const
const BULGE_WIDTH = [1, 50, 0.5] as const
const DEPTH = [-3, 3, 0.02] as const
const FRACTION = [0, 1, 0.01] as const
/** Range for the width of the raised banks beside the valley, millimetres. */
const BANK = [0.2, 30, 0.1] as const
const LEAN = [-0.9, 0.9, 0.05] as const
/** Range for the fraction of the length over which each end fades. At most 0.5, so that the ends do not overlap. */
const TAPER = [0, 0.5, 0.01] as const

function Shape({ shape, editor, attempt }: ControlsProps & { shape: LineShape }) {
  const { width, depth, softness, shoulder, bank, lean = 0 } = shape
  const isRaised = isBulge(shape)
  // The card over the face has the main values of a chosen line.
  const isNew = !editor.chosen.value
  const attached = isNew ? [] : editor.attachedEnds.value
  const slider = (
    label: string,
    range: readonly [number, number, number],
    value: number,
    fields: (value: number) => Partial<LineShape>,
  ) => (
    <NumberSlider
      label={label}
      range={range}
      value={value}
      onMove={(next) => attempt(() => editor.setShape(fields(next)))}
      onRest={() => editor.settle()}
    />
  )
  return (
    <div>
      {isNew && slider(LINE.width, isRaised ? BULGE_WIDTH : WIDTH, width, (value) => ({ width: value }))}
      {isNew && slider(LINE.depth, DEPTH, depth, (value) => ({ depth: value }))}
      {isRaised && <p class="hint">A negative depth raises the skin: the line is a bulge.</p>}
      {!isRaised && (
        <>
          {isNew && slider(LINE.softness, FRACTION, softness, (value) => ({ softness: value }))}
          {slider(LINE.shoulder, FRACTION, mean(shoulder), (value) => ({ shoulder: [value, value] }))}
          {slider(LINE.bank, BANK, bank ? mean(bank) : BANK_WIDTHS * width, (value) => ({
            bank: [value, value],
          }))}
        </>
      )}
      {slider(LINE.lean, LEAN, lean, (value) => ({ lean: value }))}
      {slider(LINE.taper, TAPER, meanTaper(shape, attached), (value) => ({ taper: [value, value] }))}
    </div>
  )
}

function mean([a, b]: readonly [number, number]): number {
  return (a + b) / 2
}

interface MembershipProps extends ControlsProps {
  group: string
  layer: string
  /** Whether the fields apply to new lines. If a field is empty, a new line gets the value of the area that it is drawn on. */
  isNew: boolean
  groups: readonly string[]
  layers: readonly string[]
}

/** Fields for the group and the layer of a line. */
function Membership({ group, layer, isNew, groups, layers, editor, attempt }: MembershipProps) {
  const id = useId()
  return (
    <>
      <div class="setting">
        <label for={`${id}-group`}>{LINE.group}</label>
        <input
          id={`${id}-group`}
          type="search"
          list={`${id}-groups`}
          value={group}
          placeholder={isNew ? 'The region under the line' : 'A new name creates a region'}
          onChange={({ currentTarget }) => attempt(() => editor.setGroup(currentTarget.value.trim()))}
        />
        <datalist id={`${id}-groups`}>
          {groups.map((name) => (
            <option key={name} value={name} />
          ))}
        </datalist>
      </div>
      <div class="setting">
        <label for={`${id}-layer`}>{LINE.layer}</label>
        <select
          id={`${id}-layer`}
          value={layer}
          onChange={({ currentTarget }) => attempt(() => editor.setLayer(currentTarget.value))}
        >
          {isNew && <option value="">The layer of the region</option>}
          {layers.map((name) => (
            <option key={name} value={name}>
              {name}
            </option>
          ))}
        </select>
      </div>
    </>
  )
}

function groupsOf({ document }: PanelModel['session']): string[] {
  const { areas, strokes } = document.value ?? { areas: [], strokes: [] }
  return [...new Set([...areas.map(({ name }) => name), ...strokes.flatMap(({ group }) => group ?? [])])]
}

/** Whether a point of the spline is chosen, not only a fork between two points. */
function hasPoint({ handles, point }: LineEditor): boolean {
  return (handles.value[point.value]?.knot ?? -1) >= 0
}

function Operations({ editor, attempt }: ControlsProps) {
  const isSeveral = editor.allChosen.value.length > 1
  const buttons: readonly [label: string, title: string, action: () => void, isDisabled?: boolean][] = [
    [LINE.smooth, 'Removes jitter, and keeps bends', () => editor.smooth()],
    [LINE.split, 'At the chosen point, or in the middle', () => editor.split(), isSeveral],
    [LINE.mirror, 'Adds its mirror image', () => editor.mirror()],
    [
      LINE.detach,
      'Shortens the line where it ends on another line',
      () => editor.detach(),
      isSeveral || editor.attachedEnds.value.length === 0,
    ],
    [isSeveral ? LINE.removeLines : LINE.remove, '', () => editor.removeLine()],
    [LINE.removePoint, 'Removes the chosen point', () => editor.remove(), !hasPoint(editor)],
    [
      LINE.chooseGroup,
      'Chooses all lines of the region',
      () => editor.chooseGroup(),
      editor.chosen.value?.group === undefined,
    ],
  ]
  return (
    <fieldset class="grid lines-actions" aria-label={isSeveral ? 'Chosen lines' : 'Chosen line'}>
      {buttons.map(([label, title, action, isDisabled]) => (
        <button key={label} type="button" title={title} disabled={isDisabled} onClick={() => attempt(action)}>
          {label}
        </button>
      ))}
    </fieldset>
  )
}
