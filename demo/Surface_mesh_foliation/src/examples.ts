// Meshes that come with the page: of CGAL's data, put into the folder `examples` by the build.

export interface Example {
  name: string;
  label: string;
}

export const EXAMPLES: Example[] = [
  { name: 'homer', label: 'Homer' },
  { name: 'hand', label: 'Hand' },
  { name: 'elephant', label: 'Elephant, with handles' },
  { name: 'cow', label: 'Cow' },
  { name: 'camel', label: 'Camel' },
  { name: 'eight', label: 'Eight, genus 2' },
];

export function isExample(name: string): boolean {
  return EXAMPLES.some((example) => example.name === name);
}

/** The bytes of an example. This and the page's own parts are all that is ever fetched. */
export async function fetchExample(name: string): Promise<ArrayBuffer> {
  const answer = await fetch(`examples/${name}.off`);
  if (!answer.ok) throw new Error(`The example ${name} is not there (${answer.status})`);
  return answer.arrayBuffer();
}
