// Fifty plants of five kinds, each with levels of detail, in one wind.

import { PlantLod, Wind } from "bough/three";
import { startPool } from "bough/worker";
import * as THREE from "three";

const kinds = Array.from({ length: 5 }, (_, kind) => ({
  axis: { segments: 7, segmentLength: 0.035, radius: 0.0018, elevation: 90 - 2 * kind },
  branching: { pattern: "bifurcation", generations: 4, girthRatio: 0.65 + 0.07 * kind, lengthRatio: 0.9 },
  growth: { thickening: "pipes" },
  material: { youngsModulus: 4e8 },
  tropism: { strength: 0.4 + 0.3 * kind },
}));

const pool = await startPool();
const grown = await Promise.all(kinds.map((params) => pool.plant(params)));
pool.dispose();

const canvas = document.querySelector("canvas");
const renderer = new THREE.WebGLRenderer({ canvas, antialias: true });
renderer.shadowMap.enabled = true;
const scene = new THREE.Scene();
scene.background = new THREE.Color("#dfe7e4");
scene.fog = new THREE.Fog("#dfe7e4", 5, 14);

const sun = new THREE.DirectionalLight("#fff3dc", 2.6);
sun.position.set(-3, 6, 4);
sun.castShadow = true;
sun.shadow.mapSize.set(1024, 1024);
sun.shadow.normalBias = 0.02;
Object.assign(sun.shadow.camera, { left: -5, right: 5, top: 5, bottom: -5 });
scene.add(sun, new THREE.HemisphereLight("#f4f8ff", "#93a07c", 1.6));

const ground = new THREE.Mesh(
  new THREE.CircleGeometry(30, 48).rotateX(-Math.PI / 2),
  new THREE.MeshStandardMaterial({ color: "#a9b58d", roughness: 1 }),
);
ground.receiveShadow = true;
scene.add(ground);

// Plants of one kind share geometries and materials: a clone costs next to nothing.
const wind = new Wind(new THREE.Vector3(0.09, 0, 0.03));
const originals = grown.map((plant) => new PlantLod(plant));
for (const original of originals) wind.blow(original);
for (let i = 0; i < 50; i++) {
  const plant = originals[i % originals.length].clone();
  // A sunflower's spiral: even, but in no rows.
  const [angle, distance] = [2.4 * i, 0.52 * Math.sqrt(i + 0.5)];
  plant.position.set(distance * Math.cos(angle), 0, distance * Math.sin(angle));
  plant.rotation.y = 1.7 * i;
  plant.scale.setScalar(0.75 + 0.5 * ((i * 0.618) % 1));
  wind.blow(plant);
  scene.add(plant);
}

const camera = new THREE.PerspectiveCamera(38, 1, 0.05, 50);
camera.position.set(0, 1.5, 7);
camera.lookAt(0, 0.55, 0);

renderer.setAnimationLoop((milliseconds) => {
  const { clientWidth: width, clientHeight: height } = canvas;
  if (canvas.width !== width || canvas.height !== height) {
    renderer.setSize(width, height, false);
    camera.aspect = width / height;
    camera.updateProjectionMatrix();
  }
  wind.time = milliseconds / 1000;
  renderer.render(scene, camera);
  const { triangles, calls } = renderer.info.render;
  document.querySelector("#report").textContent =
    `50 plants, ${triangles.toLocaleString("en")} triangles in ${calls} calls`;
});
