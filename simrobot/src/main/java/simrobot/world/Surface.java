package simrobot.world;

/** A part of the floor that acts on the wheels of every robot whose centre of rotation is on it. */
public interface Surface extends AreaItem {
    /** Velocity of the floor along x, metres per second. */
    default double velocityX() {
        return 0;
    }

    /** Velocity of the floor along y, metres per second. */
    default double velocityY() {
        return 0;
    }

    default boolean isMoving() {
        return velocityX() != 0 || velocityY() != 0;
    }

    /** The robot's motion per metre or radian of its wheels, 0 to 1: below 1 the wheels slip. */
    default double grip() {
        return 1;
    }

    /** Its colour in a robot's camera, 0xRRGGBB. */
    int cameraColour();
}
