import { existsSync } from 'node:fs'
import { basename, dirname, join, relative } from 'node:path'
import { writeAll } from '../files.ts'
import { warn } from '../print.ts'
import { withBar } from '../progress.ts'
import { version } from '../version.ts'
import type { Entry } from './inputs/entry.ts'
import type { JobCommandName } from './jobs/job-commands.ts'
import { makePlan, type Plan } from './plan.ts'
import { batchPage } from './report/page.ts'
import { rowsOf } from './report/rows.ts'
import { drawThumbnails, thumbnailNames } from './report/thumbnails.ts'
import { openResults, type ResultLine, readResults } from './results.ts'
import { type Engine, runTasks } from './run-tasks.ts'
import { isRemote } from './stores/store-of.ts'
import { type BatchCounts, countsOf, countsText, Rate } from './summary.ts'

const WHO = 'furrow batch'

/** Options and inputs of a batch, parsed and checked. */
export interface Batch {
  command: JobCommandName
  entries: readonly Entry[]
  /** Path of the results file. */
  results: string
  /** Path of the HTML report. */
  page: string
  thumbnails: number
}

/** Runs a batch, or resumes it if the results file has results of an earlier run. */
export async function runBatch(batch: Batch, engine: Engine): Promise<BatchCounts> {
  const plan = await planOf(batch)
  const lines = await runPlan(plan, batch, engine)
  const counts = countsOf(lines, plan.kept.length)
  await writePage(batch, lines, countsText(counts))
  return counts
}

function planOf({ command, entries, results }: Batch): Promise<Plan> {
  const earlier = readResults(results)
  return withBar('reading', (progress) => {
    return makePlan(entries, {
      command,
      version,
      earlier,
      progress: (done) => progress(done, entries.length),
    })
  })
}

async function runPlan({ tasks, failed, kept }: Plan, batch: Batch, engine: Engine): Promise<ResultLine[]> {
  const lines = [...kept]
  const results = openResults(batch.results)
  try {
    await withBar('batch', async (progress) => {
      const total = batch.entries.length - kept.length
      const rate = new Rate(performance.now())
      let [ended, failures] = [0, 0]
      const add = (added: readonly ResultLine[]) => {
        for (const line of added) results.add(line)
        lines.push(...added)
        ended += added.length
        failures += added.filter(({ status }) => status === 'failed').length
        const parts = [
          `${ended}/${total}`,
          failures > 0 && `${failures} failed`,
          rate.text(ended, total, performance.now()),
        ]
        progress(ended, total, parts.filter(Boolean).join(', '))
      }
      add(failed)
      await runTasks(tasks, engine, add)
    })
  } finally {
    results.close()
  }
  return lines
}

async function writePage(batch: Batch, lines: readonly ResultLine[], summary: string): Promise<void> {
  const folder = dirname(batch.page)
  const pictures = join(folder, 'thumbnails')
  const isDrawn = ({ key = '' }: ResultLine) =>
    thumbnailNames(key).every((name) => existsSync(join(pictures, name)))
  const faces = rowsOf(lines).filter(({ status, output }) => status === 'done' && output !== undefined)
  const chosen = new Map(faces.slice(0, batch.thumbnails).map((line) => [line.key, line]))
  const notes = await withBar('thumbnails', (progress) =>
    drawThumbnails([...chosen.values()], pictures, (done) => progress(done, chosen.size)),
  )
  for (const note of notes) warn(`${WHO}: some thumbnails are missing (${note})`)
  const page = batchPage({
    command: batch.command,
    lines,
    summary,
    results: basename(batch.results),
    notes: notes.map((note) => `Some thumbnails are missing. ${note}`),
    linkTo: (output) => (isRemote(output) ? output : urlPath(relative(folder, output))),
    thumbnails: (line) => {
      if (line.status === 'failed' || !chosen.has(line.key) || !isDrawn(line)) return undefined
      const [before, after] = thumbnailNames(line.key!)
      return [`thumbnails/${before}`, `thumbnails/${after}`]
    },
  })
  await writeAll([{ path: batch.page, bytes: Buffer.from(page) }], WHO)
}

const urlPath = (path: string) => path.split(/[\\/]/).map(encodeURIComponent).join('/')
