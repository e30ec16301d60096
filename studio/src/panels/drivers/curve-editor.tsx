import { effect, type ReadonlySignal, useSignal } from '@preact/signals'
import type { Curve } from 'furrow'
import { curveAt } from 'furrow/internal'
import { useLayoutEffect, useRef } from 'preact/hooks'
import {
  addPoint,
  type CurveRanges,
  movePoint,
  type Range,
  removePoint,
  stepOf,
  widestGap,
} from '../../document/curve.ts'
import {
  CURVE,
  curveLabel,
  curvePointLabel,
  curvePointOfLabel,
  curveValueLabel,
  removeCurvePointLabel,
} from '../../labels/drivers.ts'
import { type ShortcutName, shortcutOf } from '../../shortcuts.ts'
import { type Axis, textOn } from './axes.ts'
import { NumberField } from './number-field.tsx'

/** Size in SVG units. The picture is scaled to the width of the panel. */
const WIDTH = 280
const HEIGHT = 124
const MARGIN = { side: 10, top: 10, bottom: 22 }

interface CurveEditorProps {
  /** Name of the curve, for screen readers. */
  label: string
  curve: Readonly<Curve>
  axis: Axis
  /** Range of the outputs that the user can type. */
  outputs: Range
  /** Current input of the curve, or null if unknown. */
  now: ReadonlySignal<number | null>
  /** Called for each change of the curve. */
  onMove(curve: Curve): void
  /** Called after the last change of a gesture, for example when a point or an arrow key is released. */
  onRest(): void
}

/**
 * Editor for a curve. The curve maps an input of a driver to an activation. The pointer or arrow keys move points. A double click or a button adds
 * a point. A marker shows the current input. When the marker moves, only the DOM changes, and the component is not rendered.
 */
export function CurveEditor({ label, curve, axis, outputs, now, onMove, onRest }: CurveEditorProps) {
  const dragged = useSignal<{ index: number; ranges: CurveRanges; grip: readonly [number, number] } | null>(
    null,
  )
  const chosen = useSignal(0)
  const svg = useRef<SVGSVGElement>(null)
  // The axes stay fixed while a point is dragged.
  const ranges = dragged.value?.ranges ?? { input: axis.range, output: drawnOutputs(curve) }
  const plot = plotOf(ranges)
  const index = Math.min(chosen.value, curve.length - 1)
  const [input, output] = curve[index]
  const change = (next: Curve) => {
    onMove(next)
    onRest()
  }
  const add = (at: number) => {
    const next = addPoint(curve, at, ranges)
    const added = next.findIndex(([other], i) => other !== curve[i]?.[0])
    if (next.length === curve.length) return
    chosen.value = added
    change(next)
  }
  const remove = (at: number) => {
    if (curve.length > 2) change(removePoint(curve, at))
  }
  return (
    <fieldset class="curve" aria-label={curveLabel(label)}>
      <svg
        class="curve-plot"
        ref={svg}
        viewBox={`0 0 ${WIDTH} ${HEIGHT}`}
        onDblClick={(event) => {
          const isOnPoint = (event.target as Element).closest('[role=slider]')
          if (!isOnPoint) add(plot.valueAt(pointIn(svg.current!, event))[0])
        }}
      >
        <title>{CURVE.hint}</title>
        <Grid plot={plot} axis={axis} ranges={ranges} />
        <polyline class="curve-line" points={lineOf(curve, plot, ranges.input)} />
        <Marker curve={curve} plot={plot} now={now} range={ranges.input} />
        {curve.map((point, i) => (
          <g
            key={i}
            class={`curve-point ${i === index ? 'chosen' : ''}`}
            transform={`translate(${plot.x(point[0])} ${plot.y(point[1])})`}
            role="slider"
            tabIndex={0}
            aria-label={curvePointOfLabel(i + 1, curve.length)}
            aria-valuemin={ranges.output[0]}
            aria-valuemax={ranges.output[1]}
            aria-valuenow={point[1]}
            aria-valuetext={curveValueLabel(axis.label, textOn(axis, point[0]), point[1])}
            onFocus={() => {
              chosen.value = i
            }}
            onKeyDown={(event) => {
              const name = shortcutOf('curve', event)
              if (!name) return
              event.preventDefault()
              event.stopPropagation()
              if (name === 'remove') return remove(i)
              const move = MOVES[name]
              const factor = event.shiftKey ? 10 : 1
              const [dx, dy] = [stepOf(ranges.input), stepOf(ranges.output)]
              const next = [point[0] + move[0] * factor * dx, point[1] + move[1] * factor * dy] as const
              onMove(movePoint(curve, i, next, ranges))
            }}
            onKeyUp={onRest}
            onPointerDown={(event) => {
              if (event.button !== 0) return
              event.currentTarget.setPointerCapture(event.pointerId)
              const [x, y] = pointIn(svg.current!, event)
              const grip = [plot.x(point[0]) - x, plot.y(point[1]) - y] as const
              dragged.value = { index: i, ranges, grip }
            }}
            onPointerMove={(event) => {
              const drag = dragged.peek()
              if (drag?.index !== i) return
              const [x, y] = pointIn(svg.current!, event)
              onMove(movePoint(curve, i, plot.valueAt([x + drag.grip[0], y + drag.grip[1]]), ranges))
            }}
            onLostPointerCapture={() => {
              dragged.value = null
              onRest()
            }}
          >
            <circle class="curve-grip" r="15" />
            <circle class="curve-dot" r="5" />
          </g>
        ))}
      </svg>
      <div class="curve-fields">
        <NumberField
          label={curvePointLabel(index + 1)}
          value={input * axis.factor}
          step={Number((stepOf(axis.range) * axis.factor).toPrecision(1))}
          unit={axis.unit}
          onChange={(next) => {
            const at = next / axis.factor
            change(movePoint(curve, index, [at, output], { ...ranges, input: widened(ranges.input, at) }))
          }}
        />
        <NumberField
          label={CURVE.gives}
          value={output}
          step={0.01}
          range={outputs}
          onChange={(next) => {
            const drawn = { ...ranges, output: widened(ranges.output, next) }
            change(movePoint(curve, index, [input, next], drawn))
          }}
        />
        <span class="curve-buttons">
          <button
            type="button"
            title={CURVE.add}
            aria-label={CURVE.add}
            onClick={() => add(widestGap(curve))}
          >
            +
          </button>
          <button
            type="button"
            title={CURVE.remove}
            aria-label={removeCurvePointLabel(index + 1)}
            disabled={curve.length === 2}
            onClick={() => remove(index)}
          >
            −
          </button>
        </span>
      </div>
    </fieldset>
  )
}

const MOVES: Record<Exclude<ShortcutName<'curve'>, 'remove'>, readonly [number, number]> = {
  left: [-1, 0],
  right: [1, 0],
  down: [0, -1],
  up: [0, 1],
}

/** Functions that convert between values of the curve and SVG units. */
interface Plot {
  x(input: number): number
  y(output: number): number
  valueAt(point: readonly [number, number]): [number, number]
}

function plotOf({ input: [left, right], output: [bottom, top] }: CurveRanges): Plot {
  const width = WIDTH - 2 * MARGIN.side
  const height = HEIGHT - MARGIN.top - MARGIN.bottom
  return {
    x: (input) => MARGIN.side + (width * (input - left)) / (right - left),
    y: (output) => MARGIN.top + (height * (top - output)) / (top - bottom),
    valueAt: ([x, y]) => [
      left + ((right - left) * (x - MARGIN.side)) / width,
      top - ((top - bottom) * (y - MARGIN.top)) / height,
    ],
  }
}

function pointIn(svg: SVGSVGElement, { clientX, clientY }: MouseEvent): [number, number] {
  const { left, top, width, height } = svg.getBoundingClientRect()
  return [((clientX - left) / width) * WIDTH, ((clientY - top) / height) * HEIGHT]
}

function drawnOutputs(curve: Readonly<Curve>): Range {
  const outputs = curve.map(([, output]) => output)
  return [Math.min(0, ...outputs), Math.max(1, ...outputs)]
}

function widened([low, high]: Range, value: number): Range {
  return [Math.min(low, value), Math.max(high, value)]
}

/** Returns the polyline of a curve. Beyond its ends, the curve is constant. */
function lineOf(curve: Readonly<Curve>, plot: Plot, [left, right]: Range): string {
  const points = [[left, curveAt(curve, left)], ...curve, [right, curveAt(curve, right)]]
  return points.map(([input, output]) => `${plot.x(input)},${plot.y(output)}`).join(' ')
}

function Grid({ plot, axis, ranges }: { plot: Plot; axis: Axis; ranges: CurveRanges }) {
  const [left, right] = ranges.input
  const [bottom, top] = ranges.output
  const quarters = [0, 0.25, 0.5, 0.75, 1]
  const d = quarters
    .map((t) => {
      const [x, y] = [plot.x(left + t * (right - left)), plot.y(bottom + t * (top - bottom))]
      return `M${x} ${plot.y(bottom)}V${plot.y(top)}M${plot.x(left)} ${y}H${plot.x(right)}`
    })
    .join('')
  return (
    <g>
      <path class="curve-grid" d={d} />
      <text x={MARGIN.side} y={HEIGHT - 6}>
        {textOn(axis, left)}
      </text>
      <text x={WIDTH / 2} y={HEIGHT - 6} text-anchor="middle">
        {axis.label}
      </text>
      <text x={WIDTH - MARGIN.side} y={HEIGHT - 6} text-anchor="end">
        {textOn(axis, right)}
      </text>
    </g>
  )
}

interface MarkerProps {
  curve: Readonly<Curve>
  plot: Plot
  now: ReadonlySignal<number | null>
  range: Range
}

/** Marker at the current input and output, clamped to the plot. */
function Marker({ curve, plot, now, range: [left, right] }: MarkerProps) {
  const line = useRef<SVGLineElement>(null)
  const dot = useRef<SVGCircleElement>(null)
  useLayoutEffect(() => {
    return effect(() => {
      const input = now.value
      for (const element of [line.current!, dot.current!]) {
        element.style.display = input === null ? 'none' : ''
      }
      if (input === null) return
      const x = plot.x(Math.min(right, Math.max(left, input)))
      line.current!.setAttribute('transform', `translate(${x} 0)`)
      dot.current!.setAttribute('transform', `translate(${x} ${plot.y(curveAt(curve, input))})`)
    })
  })
  return (
    <g class="curve-now">
      <line ref={line} y1={MARGIN.top} y2={HEIGHT - MARGIN.bottom} />
      <circle ref={dot} r="3.5" />
    </g>
  )
}
