// Makes automatic wrinkles in a web worker, for a small sheet that a blendshape compresses. The page's title reports the result.
import { autoWrinklesInWorker } from 'furrow/auto'

const N = 16
const [positions, uvs, indices, offsets] = [[], [], [], []]
for (let j = 0; j <= N; j++) {
  for (let i = 0; i <= N; i++) {
    positions.push((0.08 * i) / N, (0.08 * j) / N, 0)
    uvs.push(i / N, 1 - j / N)
    offsets.push(-0.2 * positions.at(-3), 0, 0)
    const p = j * (N + 1) + i
    if (i < N && j < N) indices.push(p, p + 1, p + N + 2, p, p + N + 2, p + N + 1)
  }
}

const steps = new Set()
const options = { size: 256, areaSize: 32, progress: (_done, _total, step) => steps.add(step) }
try {
  const skin = { positions, uvs, indices, targets: [{ name: 'squash', offsets }] }
  const { areas, layers } = await autoWrinklesInWorker(skin, options)
  document.title = `${areas.length} area, ${layers[0].normal.data.length} bytes, ends with ${[...steps].at(-1)}`
} catch (error) {
  document.title = error.message
}
