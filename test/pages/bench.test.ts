import { execFile } from 'node:child_process'
import { existsSync, mkdtempSync, readFileSync, realpathSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { dirname, join } from 'node:path'
import { promisify } from 'node:util'
import { afterAll, expect, it } from 'vitest'
import type { Result } from '../../bench/report.ts'
import { findBrowser } from '../../packages/cli/src/browser.ts'

const folder = mkdtempSync(join(tmpdir(), 'furrow-bench-'))
afterAll(() => rmSync(folder, { recursive: true }))

/** Returns environment variables that make Dawn use the Vulkan loader and software rasteriser of Chromium. */
async function dawnEnvironment(): Promise<NodeJS.ProcessEnv> {
  const candidates = [dirname(realpathSync(await findBrowser())), '/usr/lib/chromium']
  const chromium = candidates.find((path) => existsSync(join(path, 'vk_swiftshader_icd.json')))
  if (!chromium) return process.env
  return {
    ...process.env,
    LD_LIBRARY_PATH: chromium,
    VK_DRIVER_FILES: join(chromium, 'vk_swiftshader_icd.json'),
  }
}

const runBench = async (...args: string[]) =>
  promisify(execFile)(
    process.execPath,
    ['bench/run.mjs', '--node', '--quick', '--rounds', '1', '--size', '80x60', ...args],
    {
      env: await dawnEnvironment(),
    },
  )

it('runs in Node on Dawn, timed by timestamps', async () => {
  const json = join(folder, 'results.json')
  const { stdout } = await runBench('--json', json)
  const results: Result[] = JSON.parse(readFileSync(json, 'utf8'))
  const variants = new Set(results.map(({ variant }) => variant))
  expect([...variants].sort().join(' ')).toBe(
    'composed copied furrow jimenez o3de paper plain relief shared stripped',
  )
  for (const result of results) {
    expect(result).toMatchObject({ renderer: 'webgpu', timing: 'timestamps', width: 80, height: 60 })
    expect(result.adapter).not.toBe('')
    expect(result.medianMs).toBeGreaterThan(0)
    expect(result.ratioToPlain).toBeGreaterThan(0)
  }
  for (const crowd of ['1000 faces of 60 pixels', '10000 faces of 20 pixels']) {
    expect(stdout).toMatch(new RegExp(`\\d% \\(quartiles .*\\) of a frame with ${crowd} on webgpu`))
  }
  expect(stdout).toMatch(
    /\d ms for 64 x 64 texels of a normal map of 1024 x 1024 on webgpu, -?\d+\.\d ms for all/,
  )
})

it('reports that WebGL is unavailable in Node', async () => {
  await expect(runBench('--renderer', 'webgl')).rejects.toThrow(
    'renderer not available here, got "webgl", allowed: webgpu',
  )
})
