// Contents of the navigation bar and the sidebars.

import { GROUPS, readExamples } from '../../scripts/lib/examples.mjs'
import { readCommands } from '../gather/commands.mjs'

const doc = (text, name) => ({ text, link: `/docs/${name}` })
const group = (text, items, more) => ({ text, items, ...more })

const GUIDES = [
  group('Start', [
    { text: 'Overview', link: '/overview' },
    doc('Guide', 'guide'),
    doc('Studio', 'studio'),
    doc('Tasks in the studio', 'studio-tasks'),
  ]),
  group('Make wrinkles', [
    doc('From blendshapes', 'auto'),
    doc('Hands, necks and clothes', 'body'),
    doc('Folds from joints, body by body', 'body-sheets'),
    doc('In the page', 'auto-in-the-page'),
    doc('Characters and rigs', 'auto-formats'),
    doc('Recognised blendshapes', 'shapes'),
    doc('How automatic lines are made', 'auto-lines'),
    doc('Fine furrows', 'auto-furrows'),
    doc('Measured on many people', 'auto-people'),
    doc('Region by region', 'auto-sheets'),
    doc('Drawn as strokes', 'strokes'),
    doc('Strokes: the format', 'strokes-format'),
    doc('wrinkles.json', 'wrinkles-json'),
    doc('Baked from a sculpt', 'bake'),
    doc('Normal maps from heights', 'normals'),
    doc('From other programs', 'import'),
    doc('Character Creator', 'import-character-creator'),
    doc('MetaHuman', 'import-metahuman'),
    doc('Expression maps', 'import-expressions'),
  ]),
  group('Drive them', [
    doc('Drivers', 'drivers'),
    doc('Drivers in the studio', 'studio-drivers'),
    doc('Joints in the studio', 'studio-joints'),
    doc('Live faces in the studio', 'studio-motion'),
    doc('Layers, projects and files', 'studio-files'),
    doc('Expressions', 'expressions'),
    doc('Face tracking', 'tracking'),
    doc('Live trackers', 'live'),
    doc('Blendshapes without normals', 'morph-normals'),
  ]),
  group('Show them', [
    doc('three.js', 'three'),
    doc('Materials and modes', 'materials'),
    doc('Many faces', 'crowds'),
    doc('Skin', 'skin'),
    doc('React Three Fiber', 'react'),
    doc('Other frameworks', 'frameworks'),
    doc('Babylon.js', 'babylon'),
    { text: 'Godot', link: '/godot/' },
    doc('Inspector', 'inspector'),
    doc('VRM', 'vrm'),
    doc('Blender', 'blender'),
  ]),
  group('Ship them', [
    doc('Pack', 'pack'),
    doc('Inspect and validate', 'inspect'),
    doc('glTF-Transform', 'transform'),
    doc('Many files at once', 'batch'),
    doc('Batches on many machines', 'batch-machines'),
    doc('Texture arrays', 'array'),
    doc('Files of the commands', 'files'),
    doc('Download', 'download'),
  ]),
  group('The format', [
    doc('FURROW_wrinkle_maps', 'FURROW_wrinkle_maps'),
    doc('Conformance', 'conformance'),
    doc('Add an engine', 'engine'),
    doc('Architecture', 'architecture'),
    doc('Versions', 'versions'),
  ]),
  group('The project', [
    doc('The paper, point by point', 'paper'),
    doc('Compared with a path tracer', 'realism'),
    { text: 'Benchmark', link: '/bench/' },
    { text: 'The faces', link: '/faces/' },
    { text: 'Contributing', link: '/CONTRIBUTING' },
    { text: 'Security', link: '/SECURITY' },
    { text: 'Changelog', link: '/CHANGELOG' },
  ]),
]

const API = [
  'furrow',
  'furrow.three',
  'furrow.webgpu',
  'furrow.inspector',
  'furrow.react',
  'furrow.react.webgpu',
  'furrow.babylon',
  'furrow.author',
  'furrow.auto',
  'furrow.gltf',
].map((name) => ({ text: name.replaceAll('.', '/'), link: `/docs/api/${name}` }))

export async function sidebar() {
  const commands = (await readCommands()).map((command) => command.name())
  const examples = readExamples()
  return {
    '/docs/api/': [group('API reference', [{ text: 'Entries', link: '/docs/api/' }, ...API])],
    '/commands/': [
      group('Commands', [
        { text: 'All commands', link: '/commands/' },
        ...commands.map((name) => ({ text: name, link: `/commands/${name}` })),
      ]),
    ],
    '/examples/': [
      group('Examples', [{ text: 'All examples', link: '/examples/' }]),
      ...GROUPS.map((name) => group(name, examplesIn(examples, name))).filter(
        ({ items }) => items.length > 0,
      ),
    ],
    '/': GUIDES,
  }
}

function examplesIn(examples, group) {
  return examples
    .filter((example) => example.group === group)
    .map(({ name, title }) => ({ text: title, link: `/examples/${name}` }))
}

export const NAVIGATION = [
  { text: 'Guide', link: '/docs/guide', activeMatch: '^/(docs/(?!api/)|overview|faces/)' },
  { text: 'Examples', link: '/examples/', activeMatch: '^/examples/' },
  { text: 'Commands', link: '/commands/', activeMatch: '^/commands/' },
  { text: 'API', link: '/docs/api/', activeMatch: '^/docs/api/' },
  { text: 'Benchmark', link: '/bench/', activeMatch: '^/bench/' },
  { text: 'Studio', link: '/studio/index.html', target: '_self', noIcon: true },
]
