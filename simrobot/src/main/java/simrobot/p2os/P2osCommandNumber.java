package simrobot.p2os;

/** The numbers of the supported commands (P2OS manual, ARIA's ArCommands, MobileSim's own from 224 on). */
public final class P2osCommandNumber {
    /** The first step of the handshake, later the keep-alive. */
    public static final int PULSE = 0;
    /** The second step of the handshake, later the opening of the session. */
    public static final int OPEN = 1;
    /** The last step of the handshake, later the session's end. */
    public static final int CLOSE = 2;
    /** The order of the sonars, counted from 1. */
    public static final int POLLING = 3;

    public static final int ENABLE = 4;
    /** Acceleration in mm/s2; negative values set the deceleration. */
    public static final int SETA = 5;
    /** Top speed in mm/s. */
    public static final int SETV = 6;
    /** Sets the odometry to 0, 0, 0. */
    public static final int SETO = 7;
    /** Drives this distance in mm. */
    public static final int MOVE = 8;
    /** Turns at this speed in degrees/s, as RVEL. */
    public static final int ROTATE = 9;
    /** Top turning speed in degrees/s. */
    public static final int SETRV = 10;
    /** Drives at this speed in mm/s. */
    public static final int VEL = 11;
    /** Turns to an absolute heading of the odometry in degrees, through the smaller angle. */
    public static final int HEAD = 12;
    /** Turns by degrees relative to the current heading. */
    public static final int DHEAD = 13;

    public static final int CONFIG = 18;
    /** Selects when encoder packets are sent: 0 never, 1 once, 2 with every information packet. */
    public static final int ENCODER = 19;

    public static final int RVEL = 21;
    /** Turns by degrees relative to the heading that the robot is turning to. */
    public static final int DCHEAD = 22;
    /** Angular acceleration in degrees/s2; negative values set the deceleration. */
    public static final int SETRA = 23;

    public static final int SONAR = 28;
    public static final int STOP = 29;
    /** Each wheel's speed in units of 20 mm/s, the left one in the upper octet. */
    public static final int VEL2 = 32;
    /** 0 off, 1 plain packets, 2 extended ones. */
    public static final int LASER = 35;
    /** Degrees of the first reading. */
    public static final int LASER_START = 36;
    /** Degrees of the last reading. */
    public static final int LASER_END = 37;
    /** Hundredths of a degree between readings. */
    public static final int LASER_STEP = 38;
    /** Selects the bumpers that stall the wheels at once: 0 none, 1 front, 2 rear, 3 both. */
    public static final int BUMPSTALL = 44;
    /** Stops at once, without deceleration. */
    public static final int E_STOP = 55;

    public static final int E_STOP_OLD = 57;
    /** Sets the true pose, in mm and degrees; the odometry is unchanged. */
    public static final int SIM_SET_POSE = 224;
    /** Returns the robot to its first pose and sets the odometry to 0. */
    public static final int SIM_RESET = 225;

    public static final int SIM_LRF_ENABLE = 230;
    public static final int SIM_LRF_START = 231;
    public static final int SIM_LRF_END = 232;
    public static final int SIM_LRF_STEP = 233;
    /** Loads a world. */
    public static final int SIM_CTRL = 236;
    /** Selects when the simulator's status is sent, as for the encoders; without an argument, once. */
    public static final int SIM_STAT = 237;
    /** A text for the operator. */
    public static final int SIM_MESSAGE = 238;
    /** The voltage of the battery in 0.1 V. */
    public static final int BATTEST = 250;
    /** Answer to a step of the handshake that is out of order: the client starts over. */
    public static final int OUT_OF_ORDER = 255;

    private P2osCommandNumber() {}
}
