// Runs the drop on a sphere with Bullet's soft body and measures it like our own solver (bench/drop). The stiffness is
// at its maximum. Searches the fewest sub-steps that meet the stretch gate; a run that exceeds the time limit ends the
// search.
//   peer_bullet_drop [TRIANGLES [MAX_STRETCH [SECONDS_PER_RUN]]]
#include <BulletSoftBody/btSoftBody.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <BulletSoftBody/btSoftRigidDynamicsWorld.h>
#include <btBulletDynamicsCommon.h>

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <optional>

#include "bench/drop/drop.h"
#include "bench/support/cloth_run.h"
#include "bench/support/table.h"
#include "sim/core/math.h"

namespace selvedge::bench {
namespace {

constexpr int kIterations = 10;  // of the position solver, per sub-step

btScalar scalar(double value) {
    return static_cast<btScalar>(value);
}

btVector3 vector(const Vec3d& v) {
    return {scalar(v.x()), scalar(v.y()), scalar(v.z())};
}

// A Bullet world with the sphere. The members' order matters: Bullet needs destruction in the reverse order.
struct World {
    explicit World(const DropScene& scene) : shape(scalar(scene.radius)) {
        world.setGravity({0, scalar(-9.81), 0});
        shape.setMargin(scalar(1e-4));
        sphere = std::make_unique<btRigidBody>(btRigidBody::btRigidBodyConstructionInfo(0, nullptr, &shape));
        sphere->setFriction(scalar(0.6));
        world.addRigidBody(sphere.get());
        btSoftBodyWorldInfo& info = world.getWorldInfo();
        info.m_gravity = {0, scalar(-9.81), 0};
        info.air_density = 0;
        info.m_sparsesdf.Initialize();
        info.m_sparsesdf.setDefaultVoxelsz(scalar(0.01));  // m; takes effect at the next Reset()
        info.m_sparsesdf.Reset();
    }
    ~World() {
        if (cloth) world.removeSoftBody(cloth.get());
        world.removeRigidBody(sphere.get());
    }
    World(const World&) = delete;
    World& operator=(const World&) = delete;

    btSoftBodyRigidBodyCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher{&configuration};
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver solver;
    btSoftRigidDynamicsWorld world{&dispatcher, &broadphase, &solver, &configuration};
    btSphereShape shape;
    std::unique_ptr<btRigidBody> sphere;
    std::unique_ptr<btSoftBody> cloth;
};

void add_edges(btSoftBody& cloth, const sim::GarmentMesh& grid) {
    for (const sim::GarmentTriangle& t : grid.triangles) {
        for (std::size_t k = 0; k < 3; ++k) cloth.appendLink(t.vertices[k], t.vertices[(k + 1) % 3], nullptr, true);
        cloth.appendFace(t.vertices[0], t.vertices[1], t.vertices[2]);
    }
}

void add_cloth(World& world, const sim::GarmentMesh& grid, const DropScene& scene) {
    btAlignedObjectArray<btVector3> x;
    for (const Vec3d& p : grid.x) x.push_back(vector(p));
    world.cloth = std::make_unique<btSoftBody>(&world.world.getWorldInfo(), x.size(), &x[0], nullptr);
    btSoftBody& cloth = *world.cloth;
    cloth.m_materials[0]->m_kLST = 1;
    cloth.m_materials[0]->m_kAST = 1;
    add_edges(cloth, grid);
    cloth.setTotalMass(scalar(drop_fabric().area_density * scene.side * scene.side), true);
    for (int i = 0; i < x.size(); ++i)
        if ((grid.x[static_cast<std::size_t>(i)] - Vec3d(0, scene.height, 0)).norm() < 1e-6) cloth.setMass(i, 0);
    cloth.m_cfg.kDF = scalar(0.6);
    cloth.m_cfg.kKHR = 1;  // contact hardness against static and kinematic bodies
    cloth.m_cfg.piterations = kIterations;
    cloth.m_cfg.collisions = btSoftBody::fCollision::SDF_RS;
    cloth.getCollisionShape()->setMargin(scalar(1e-3));
    world.world.addSoftBody(&cloth);
}

struct PeerRun {
    DropQuality quality;
    double ms_per_frame = 0;
    double seconds = 0;
};

PeerRun run_bullet(int quads, int substeps, double limit) {
    const DropScene scene;
    const sim::GarmentMesh grid = flat_grid(quads, scene);
    World world(scene);
    add_cloth(world, grid, scene);
    DropEvaluator judge(measured(grid), scene);
    std::vector<double> seconds;
    PeerRun run;
    const double start = thread_seconds();
    for (int frame = 1; frame <= scene.frames && run.seconds < limit; ++frame) {
        const double h = scene.frame_seconds / substeps;
        const double frame_seconds = time_once([&] {
            for (int i = 0; i < substeps; ++i) world.world.stepSimulation(scalar(h), 0);
        });
        if (2 * frame > scene.frames) seconds.push_back(frame_seconds);
        run.seconds = thread_seconds() - start;
        if (!is_sampled(frame)) continue;
        std::vector<Vec3d> x;
        for (int i = 0; i < world.cloth->m_nodes.size(); ++i) {
            const btVector3& p = world.cloth->m_nodes[i].m_x;
            x.emplace_back(p.x(), p.y(), p.z());
        }
        judge.sample(x);
    }
    run.quality = judge.quality();
    run.ms_per_frame = 1e3 * quantile(seconds, 0.5);
    return run;
}

double argument(int argc, char** argv, int place, double otherwise) {
    return argc > place ? std::atof(argv[place]) : otherwise;
}

std::vector<Cell> cells_of(int substeps, const PeerRun& run) {
    const DropQuality& q = run.quality;
    return {substeps,
            Cell(run.ms_per_frame, 3),
            Cell(q.p99_stretch, 4),
            Cell(q.max_stretch, 4),
            Cell(q.p1_compression, 4),
            Cell(q.area_error, 4),
            Cell(1e3 * q.min_gap, 2)};
}

int compare(int triangles, double max_stretch, double limit) {
    constexpr int kMax = 256;
    const int quads = base_quads_for(triangles) << DropScene{}.level;
    Table table{
        .name = "bullet",
        .title = "The drop by Bullet's soft body, " + std::to_string(2 * quads * quads) + " triangles, 1 thread",
        .note = "Linear stiffness 1, " + std::to_string(kIterations) + " position iterations per sub-step."};
    table.columns = {"sub-steps", "ms per frame", "p99 stretch", "max stretch", "p1", "area error", "least gap, mm"};
    bool is_too_long = false;
    const std::optional<int> found = find_least(kMax, [&](int substeps) {
        if (is_too_long) return false;
        const PeerRun run = run_bullet(quads, substeps, limit);
        is_too_long = run.seconds >= limit;
        if (!is_too_long) table.add_row(cells_of(substeps, run));
        return !is_too_long && run.quality.is_finite && run.quality.p99_stretch <= max_stretch;
    });
    std::printf("%s\n", to_markdown(table).c_str());
    if (found) {
        std::printf("The stretch gate is met with %d sub-steps.\n", *found);
    } else {
        std::printf("The stretch gate was not met within the limit.\n");
    }
    return 0;
}

}  // namespace
}  // namespace selvedge::bench

int main(int argc, char** argv) {
    return selvedge::bench::compare(static_cast<int>(selvedge::bench::argument(argc, argv, 1, 1152)),
                                    selvedge::bench::argument(argc, argv, 2, 0.05),
                                    selvedge::bench::argument(argc, argv, 3, 60));
}
