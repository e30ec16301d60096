// `npm run sheets:scores -- blind.key.json reader1.csv reader2.csv`: prints the scores of readers by region and version as a Markdown table.

import { readFileSync } from 'node:fs'
import { parseArgs } from 'node:util'
import { importSource } from '../../../scripts/lib/import-source.mjs'
import { Failure, main } from '../../../scripts/lib/run.mjs'

await main(async () => {
  const { positionals } = parseArgs({ allowPositionals: true })
  const [keyFile, ...files] = positionals
  if (files.length === 0) throw new Failure('usage: npm run sheets:scores -- blind.key.json READER.csv...')
  const { median } = await importSource('packages/furrow/src/math/quantile.ts')
  const { versions, regions, sheets } = JSON.parse(readFileSync(keyFile, 'utf8'))
  const readers = files.map((file) => scoresOf(file, Object.keys(sheets)))
  const columns = Object.values(versions).flatMap((title) => [title, 'median'])
  console.info(`| region | ${columns.join(' | ')} |`)
  console.info(`| --- |${' --- |'.repeat(columns.length)}`)
  for (const region of regions) {
    const cells = Object.keys(versions).flatMap((version) => {
      const names = Object.keys(sheets).filter(
        (name) => sheets[name].region === region && sheets[name].version === version,
      )
      names.sort((a, b) => sheets[a].firstRow - sheets[b].firstRow)
      const scores = readers.map((scores) => names.map((name) => scores[name]))
      return names.length > 0
        ? [scores.map((each) => each.join(', ')).join('; '), median(scores.flat())]
        : ['', '']
    })
    console.info(`| \`${region}\` | ${cells.join(' | ')} |`)
  }
})

/** Reads the scores of one reader by the name of the sheet. */
function scoresOf(file, names) {
  const lines = readFileSync(file, 'utf8').trim().split('\n').slice(1)
  const scores = Object.fromEntries(
    lines.map((line) => {
      const [name, , score] = line.split(',')
      return [name, Number(score)]
    }),
  )
  const wrong = names.find((name) => !(scores[name] >= 1 && scores[name] <= 10))
  if (wrong)
    throw new Failure(`${file}: the score of ${wrong} is ${scores[wrong]}, allowed: 1 to 10; correct it`)
  return scores
}
