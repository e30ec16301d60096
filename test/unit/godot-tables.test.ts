import { ALIASES, EXPRESSIONS } from 'furrow'
import { expect, test } from 'vitest'

/** The add-on for Godot has copies of these tables. Update the copies by `npx vitest run test/unit/godot-tables.test.ts -u`. */
const FOLDER = '../../godot/addons/furrow/drivers'
const literal = (value: unknown) => JSON.stringify(value).replaceAll(',', ', ').replaceAll(':', ': ')
const script = (
  name: string,
  comment: string,
  constant: string,
  lines: readonly string[],
  [open, close]: string,
) =>
  `@tool\nclass_name ${name}\nextends RefCounted\n${comment}\n\nconst ${constant} := ${open}\n${lines.map((line) => `\t${line},\n`).join('')}${close}\n`

test("the add-on for Godot has the library's table of blendshape names", async () => {
  const comment =
    '## Names of the same blendshape in different rigs. The first name of a list is the canonical name.'
  const text = script('FurrowTargetAliases', comment, 'ALIASES', ALIASES.map(literal), '[]')
  await expect(text).toMatchFileSnapshot(`${FOLDER}/target_aliases.gd`)
})

test("the add-on for Godot has the library's expressions", async () => {
  const comment =
    '## Expressions for faces without expressions of their own: weights of blendshapes by name, and activations by area.'
  const lines = EXPRESSIONS.map(
    ({ name, ...expression }) => `${JSON.stringify(name)}: ${literal({ name, ...expression })}`,
  )
  const text = script('FurrowExpressionPresets', comment, 'EXPRESSIONS', lines, '{}')
  await expect(text).toMatchFileSnapshot(`${FOLDER}/expression_presets.gd`)
})
