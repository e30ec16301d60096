import type {
  AreaDriver,
  BoneDriver,
  DriverType,
  ExpressionDriver,
  InputDriver,
  MorphDriver,
  Rule,
  TimeDriver,
  WrinkleDriver,
} from 'furrow'
import type { AgeDriver } from 'furrow/internal'
import type { FunctionComponent } from 'preact'
import { jointsOf } from '../../viewer/pose/joints.ts'
import { NumberSlider } from '../controls/number-slider.tsx'
import { axisOf } from './axes.ts'
import type { FormProps } from './context.ts'
import { DriverCurve, NameField, optionsOf, SelectField, VectorSetting } from './fields.tsx'
import { LinkList } from './link-list.tsx'
import { MuscleForm } from './muscle-form.tsx'
import { NowSlider } from './now-slider.tsx'
import { TensionForm } from './tension-form.tsx'

const RULES: readonly (readonly [Rule, string])[] = [
  ['sum', 'Added'],
  ['max', 'The largest'],
  ['min', 'The smallest: all are needed'],
  ['product', 'Multiplied'],
]

function MorphForm({ driver, index, context }: FormProps<MorphDriver>) {
  const { targets, rule, curve } = driver
  const label = targets.length === 1 ? targets[0].name : 'Together'
  return (
    <>
      <LinkList
        {...{ index, context }}
        links={targets}
        names={context.targets}
        noun="blendshape"
        field="targets"
      />
      {targets.length > 1 && <RuleField {...{ rule, index, context }} />}
      <DriverCurve {...{ index, context, curve }} axis={axisOf('fraction', label, curve)} />
    </>
  )
}

function AreaForm({ driver, index, context }: FormProps<AreaDriver>) {
  const { areas, rule, curve } = driver
  const others = context.areas.filter((name) => name !== context.area)
  const label = areas.length === 1 ? areas[0].name : 'Together'
  return (
    <>
      <LinkList {...{ index, context }} links={areas} names={others} noun="area" field="areas" />
      {areas.length > 1 && <RuleField {...{ rule, index, context }} />}
      <DriverCurve {...{ index, context, curve }} axis={axisOf('fraction', label, curve)} />
    </>
  )
}

interface RuleFieldProps extends Omit<FormProps<never>, 'driver'> {
  rule: Rule
}

function RuleField({ rule, index, context: { editor } }: RuleFieldProps) {
  return (
    <SelectField
      label="Together"
      value={rule}
      options={RULES}
      onChange={(next) => {
        editor.set(index, 'rule', { rule: next })
        editor.settle()
      }}
    />
  )
}

function AgeForm({ driver: { curve }, index, context }: FormProps<AgeDriver>) {
  const axis = axisOf('age', 'Age, years', curve)
  return (
    <>
      <DriverCurve {...{ index, context, curve, axis }} />
      <NowSlider name="age" label="Age now" axis={axis} context={context} />
    </>
  )
}

function InputForm({ driver: { name, curve }, index, context }: FormProps<InputDriver>) {
  const axis = axisOf('number', name, curve)
  return (
    <>
      <NameField
        label="Name"
        value={name}
        onChange={(next) => {
          context.editor.set(index, 'name', { name: next })
          context.editor.settle()
        }}
      />
      <p class="hint">The application sets this number while it runs.</p>
      <DriverCurve {...{ index, context, curve, axis }} />
      <NowSlider name={name} label="Try" axis={axis} context={context} />
    </>
  )
}

const MEASURES = [
  ['angle', 'Angle'],
  ['distance', 'Distance'],
] as const

function BoneForm({ driver, index, context }: FormProps<BoneDriver>) {
  const { joints, measure, axis, curve } = driver
  const { editor, model } = context
  const root = model.viewer.value?.avatar.root
  const names = [...new Set((root ? jointsOf(root) : []).flat())]
  const set = (field: string, fields: Partial<BoneDriver> | { axis: undefined }) => {
    editor.set(index, field, fields)
    editor.settle()
  }
  return (
    <>
      <SelectField
        label="Joint"
        value={joints[1]}
        options={optionsOf(names)}
        onChange={(joint) => set('joint', { joints: [joints[0], joint] })}
      />
      <SelectField
        label={measure === 'angle' ? 'Relative to' : 'From'}
        value={joints[0]}
        options={optionsOf(names)}
        onChange={(from) => set('from', { joints: [from, joints[1]] })}
      />
      <SelectField
        label="Measure"
        value={measure}
        options={MEASURES}
        // Degrees and millimetres have no curve in common.
        onChange={(next) => set('measure', { measure: next as BoneDriver['measure'], curve: CURVES[next] })}
      />
      {measure === 'angle' && (
        <SelectField
          label="About"
          value={axis ? 'one' : 'any'}
          options={[
            ['any', 'Any axis'],
            ['one', 'One axis'],
          ]}
          onChange={(next) => set('axis', { axis: next === 'one' ? [1, 0, 0] : undefined })}
        />
      )}
      {measure === 'angle' && axis && (
        <VectorSetting
          label="Axis at rest"
          value={axis}
          step={0.1}
          onChange={(next) => set('axis', { axis: next })}
        />
      )}
      <DriverCurve {...{ index, context, curve }} axis={axisOf(measure, joints[1], curve)} />
    </>
  )
}

/** Radians and metres. */
const CURVES: Record<string, BoneDriver['curve']> = {
  angle: [
    [0, 0],
    [1.57, 1],
  ],
  distance: [
    [0, 0],
    [0.1, 1],
  ],
}

function TimeForm({ driver, index, context: { editor } }: FormProps<TimeDriver>) {
  const slider = (label: string, field: 'attack' | 'release') => (
    <NumberSlider
      label={label}
      range={[0, Math.max(2, driver[field]), 0.01]}
      value={driver[field]}
      onMove={(value) => editor.set(index, field, { [field]: value })}
      onRest={() => editor.settle()}
    />
  )
  return (
    <>
      {slider('Rises in, s', 'attack')}
      {slider('Falls in, s', 'release')}
      <p class="hint">
        Skin creases quickly and relaxes slowly. Here the area follows at once; the delay plays in the
        exported file.
      </p>
    </>
  )
}

function ExpressionForm({ driver, index, context }: FormProps<ExpressionDriver>) {
  const { name, targets, activations } = driver
  const { area, editor, pose } = context
  const own = activations.find((each) => each.area === area)
  const set = (field: string, fields: Partial<ExpressionDriver>) => {
    editor.set(index, field, fields)
    editor.settle()
  }
  return (
    <>
      <NameField label="Name" value={name} onChange={(next) => set('name', { name: next })} />
      <NumberSlider
        label="Shows it by"
        range={[0, 1, 0.01]}
        value={own?.activation ?? 0}
        onMove={(activation) => {
          const next = activations.map((each) => (each === own ? { ...each, activation } : each))
          editor.set(index, 'activation', { activations: next })
        }}
        onRest={() => editor.settle()}
      />
      <p class="hint">
        {targets.map((each) => `${each.name} ${each.weight}`).join(', ') || 'The face at rest'}
      </p>
      <div class="add">
        <button
          type="button"
          onClick={() => {
            const shapes = [...pose()].map(([target, weight]) => ({ name: target, weight }))
            set('targets', { targets: shapes })
          }}
        >
          Take the present pose
        </button>
      </div>
    </>
  )
}

/** The form of each type that an area may have. */
const FORMS: { readonly [type: string]: FunctionComponent<FormProps<never>> } = {
  morph: MorphForm,
  area: AreaForm,
  age: AgeForm,
  input: InputForm,
  bone: BoneForm,
  tension: TensionForm,
  muscle: MuscleForm,
  time: TimeForm,
  expression: ExpressionForm,
} satisfies { readonly [type in Exclude<DriverType, 'conflict'>]: unknown }

/** The fields of a driver; none of a type that this version does not know. */
export function DriverForm({ driver, ...props }: FormProps<WrinkleDriver>) {
  const Form = FORMS[driver.type]
  return Form ? <Form driver={driver as never} {...props} /> : null
}
