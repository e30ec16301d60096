import { ALIASES } from 'furrow'
import { expect, test } from 'vitest'

/** The extension reads a copy of the table. Update the copy by `npx vitest run test/unit/blender/aliases.test.ts -u`. */
test("the extension for Blender has the library's table of blendshape names", async () => {
  const text = `[\n${ALIASES.map((names) => `  ${JSON.stringify(names).replaceAll(',', ', ')}`).join(',\n')}\n]\n`
  await expect(text).toMatchFileSnapshot('../../../blender/furrow/format/aliases.json')
})
