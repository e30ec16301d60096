import { ALIASES } from 'furrow'
import { expect, test } from 'vitest'

/** Python reads a copy. After changing the table: `npx vitest run test/unit/blender/aliases.test.ts -u`. */
test("the extension for Blender has the library's names of blendshapes", async () => {
  const text = `[\n${ALIASES.map((names) => `  ${JSON.stringify(names).replaceAll(',', ', ')}`).join(',\n')}\n]\n`
  await expect(text).toMatchFileSnapshot('../../../blender/furrow/format/aliases.json')
})
