package simrobot.camera;

import simrobot.world.Goal;
import simrobot.world.Home;
import simrobot.world.Position;
import simrobot.world.Surface;
import simrobot.world.World;

/** Draws the sky, the tiled floor, and the flat marks on it: homes, goals and surfaces. */
final class BackgroundPainter {
    private static final int SKY = 0x9DB9D3;
    private static final int FLOOR = 0xA9A49A;
    private static final int JOINT = 0x8B867C;
    private static final int STRIPE = 0x6B727C;
    private static final int HOME = 0x3D6FB0;

    private static final double TILE_METERS = 0.5;
    private static final double JOINT_METERS = 0.012;
    private static final double STRIPE_METERS = 0.2;
    private static final double MARK_METERS = 0.25;
    private static final double RING_METERS = 0.05;

    /** Maximum distance of a drawn mark; beyond it a mark is at most one pixel high. */
    private static final double MARKS_RANGE_METERS = 15;

    /** Distance at which joints have faded out; beyond it they are narrower than a pixel. */
    private static final double JOINTS_RANGE_METERS = 7;

    private final PixelBuffer canvas;
    private final PinholeView eye;
    private final FacePainter painter;

    BackgroundPainter(PixelBuffer canvas, PinholeView eye) {
        this.canvas = canvas;
        this.eye = eye;
        painter = new FacePainter(canvas, eye);
    }

    void paint(World world) {
        int horizon = canvas.height / 2;
        for (int r = 0; r < horizon; r++) {
            int colour = Shading.mixed(SKY, Shading.HAZE, 1 - (double) r / horizon);
            java.util.Arrays.fill(canvas.rgb, r * canvas.width, (r + 1) * canvas.width, colour);
        }
        for (int r = horizon; r < canvas.height; r++) {
            floor(r);
        }
        canvas.clearDepth();
        world.surfaces().forEach(this::surface);
        for (Home home : world.items(Home.class)) {
            mark(home.position(), HOME);
        }
        for (int i = 0; i < world.items(Goal.class).size(); i++) {
            mark(world.items(Goal.class).get(i).position(), SignPainter.goalColour(i));
        }
        // marks are flat, so every upright object hides them
        canvas.clearDepth();
    }

    private void floor(int r) {
        double ahead = eye.depthOf(r, 0);
        double clear = Shading.clear(ahead);
        int tile = Shading.hazed(FLOOR, clear);
        double contrast = Math.max(0, 1 - ahead / JOINTS_RANGE_METERS);
        int joint = Shading.mixed(Shading.hazed(JOINT, clear), tile, contrast);
        // a joint is at least one pixel wide
        double width = Math.max(JOINT_METERS, ahead / eye.focal());
        double depthWidth = Math.max(JOINT_METERS, ahead * ahead / (eye.focal() * eye.z()));
        double across = Math.hypot(width * eye.sin(), depthWidth * eye.cos());
        double down = Math.hypot(width * eye.cos(), depthWidth * eye.sin());
        double beside = eye.slope(0) * ahead;
        double step = -ahead / eye.focal();
        int at = r * canvas.width;
        for (int c = 0; c < canvas.width; c++, beside += step) {
            boolean isJoint = contrast > 0
                    && (withinTile(eye.worldX(ahead, beside)) < across || withinTile(eye.worldY(ahead, beside)) < down);
            canvas.rgb[at++] = isJoint ? joint : tile;
        }
    }

    private static double withinTile(double meters) {
        return meters - Math.floor(meters / TILE_METERS) * TILE_METERS;
    }

    /** Draws a surface; a moving one has stripes across its direction. */
    private void surface(Surface surface) {
        double speed = Math.hypot(surface.velocityX(), surface.velocityY());
        double ux = speed == 0 ? 0 : surface.velocityX() / speed;
        double uy = speed == 0 ? 0 : surface.velocityY() / speed;
        double[] corners = surface.area().corners().stream()
                .flatMapToDouble(corner -> java.util.stream.DoubleStream.of(corner.xMeters(), corner.yMeters()))
                .toArray();
        painter.level(
                corners,
                0,
                (x, y) -> Math.floorMod((long) Math.floor((x * ux + y * uy) / STRIPE_METERS), 2L) == 0
                        ? surface.cameraColour()
                        : STRIPE);
    }

    /** Draws a ring with the diameter of a robot. */
    private void mark(Position place, int colour) {
        double px = place.xMeters();
        double py = place.yMeters();
        if (!eye.mayShow(px, py, MARK_METERS, MARKS_RANGE_METERS)) {
            return;
        }
        double[] square = {
            px - MARK_METERS,
            py - MARK_METERS,
            px + MARK_METERS,
            py - MARK_METERS,
            px + MARK_METERS,
            py + MARK_METERS,
            px - MARK_METERS,
            py + MARK_METERS
        };
        painter.level(square, 0, (x, y) -> {
            double middle = Math.hypot(x - px, y - py);
            return middle <= MARK_METERS && middle >= MARK_METERS - RING_METERS ? colour : Texture.NOTHING;
        });
    }
}
