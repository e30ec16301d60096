// Prints the table of bench/shapes.md: `npm run shape-accuracy -- FOLDER [FIRST LAST]`. The folder has heads by `faces/sample_heads.py`.

import { existsSync } from 'node:fs'
import { join } from 'node:path'
import { runnerImport } from 'vite'
import { Failure, main, ROOT } from './lib/run.mjs'
import { SOURCES } from './lib/sources.mjs'

const [folder, first = '101', last = '140'] = process.argv.slice(2)

await main(async () => {
  if (!folder || !existsSync(folder)) throw new Failure('name a folder with heads by faces/sample_heads.py')
  const { module } = await runnerImport(join(ROOT, 'scripts/lib/shape-accuracy.ts'), {
    ...SOURCES,
    environments: { inline: { resolve: { ...SOURCES.ssr.resolve, noExternal: [/^furrow/] } } },
  })
  console.info(
    '| head | templates | shapes | right | unknown | wrong | shapes that matter | wrong above 0.7 |',
  )
  console.info('| --- | --- | --- | --- | --- | --- | --- | --- |')
  for await (const row of module.accuracyOf(folder, [Number(first), Number(last)]))
    console.info(module.lineOf(row))
})
