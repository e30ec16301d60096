import { BANK_WIDTHS, isBulge } from 'furrow/internal'
import { useId } from 'preact/hooks'
import { LINE, LINE_ACTIONS, LINE_HINTS } from '../labels/lines.ts'
import type { LineEditor } from '../lines/line-editor.ts'
import { REACH_RANGE } from '../lines/line-points.ts'
import { type LineShape, meanTaper } from '../lines/line-shape.ts'
import { NumberSlider } from './controls/number-slider.tsx'
import { LineChoice, LinePoints } from './line-choice.tsx'
import type { PanelModel } from './model.ts'

/** Settings of the chosen wrinkle line, or of new lines. */
export function Lines({ model }: { model: PanelModel }) {
  const { lines, session, actions } = model
  const isNew = lines.fields.isNew.value
  const chosen = lines.chosen.value
  const shape = isNew ? lines.fields.shape.value : chosen
  return (
    <div class="settings">
      {!isNew && <LineChoice editor={lines} strokes={session.document.value?.strokes ?? []} />}
      <p class="hint">{hintOf(lines)}</p>
      {lines.mode.value === 'edit' && (
        <NumberSlider
          label={LINE.reach}
          range={[...REACH_RANGE, 0.5]}
          value={lines.points.reach.value}
          text={lines.points.reach.value.toFixed(1)}
          onMove={(reach) => {
            lines.points.reach.value = reach
          }}
        />
      )}
      {chosen && <LinePoints editor={lines} actions={actions} />}
      {shape && (
        <>
          <Shape shape={shape} editor={lines} attempt={actions.attempt} />
          <Membership
            group={isNew ? lines.fields.group.value : (chosen?.group ?? '')}
            layer={isNew ? lines.fields.layer.value : (chosen?.layer ?? '')}
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
  if (mode.value !== 'edit' || !chosen.value) return LINE_HINTS[mode.value]
  return handles.value.some(({ fork }) => fork)
    ? `${LINE_HINTS.chosen} ${LINE_HINTS.fork}`
    : LINE_HINTS.chosen
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
      onMove={(next) => attempt(() => editor.fields.setShape(fields(next)))}
      onRest={() => editor.settle()}
    />
  )
  return (
    <div>
      {isNew && slider(LINE.width, isRaised ? BULGE_WIDTH : WIDTH, width, (value) => ({ width: value }))}
      {isNew && slider(LINE.depth, DEPTH, depth, (value) => ({ depth: value }))}
      {isRaised && <p class="hint">{LINE_HINTS.bulge}</p>}
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
          placeholder={isNew ? LINE.groupUnder : LINE.newGroup}
          onChange={({ currentTarget }) => attempt(() => editor.fields.setGroup(currentTarget.value.trim()))}
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
          onChange={({ currentTarget }) => attempt(() => editor.fields.setLayer(currentTarget.value))}
        >
          {isNew && <option value="">{LINE.layerOfGroup}</option>}
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
    [LINE.smooth, LINE_ACTIONS.smooth, () => editor.smooth()],
    [LINE.split, LINE_ACTIONS.split, () => editor.split(), isSeveral],
    [LINE.mirror, LINE_ACTIONS.mirror, () => editor.mirror()],
    [
      LINE.detach,
      LINE_ACTIONS.detach,
      () => editor.detach(),
      isSeveral || editor.attachedEnds.value.length === 0,
    ],
    [isSeveral ? LINE.removeLines : LINE.remove, '', () => editor.removeLine()],
    [LINE.removePoint, LINE_ACTIONS.removePoint, () => editor.remove(), !hasPoint(editor)],
    [
      LINE.chooseGroup,
      LINE_ACTIONS.chooseGroup,
      () => editor.chooseGroup(),
      editor.chosen.value?.group === undefined,
    ],
  ]
  return (
    <fieldset class="grid lines-actions" aria-label={isSeveral ? LINE.chosenLines : LINE.chosenLine}>
      {buttons.map(([label, title, action, isDisabled]) => (
        <button key={label} type="button" title={title} disabled={isDisabled} onClick={() => attempt(action)}>
          {label}
        </button>
      ))}
    </fieldset>
  )
}
