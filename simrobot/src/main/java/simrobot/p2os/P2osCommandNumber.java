package simrobot.p2os;

/** The numbers of the supported commands (P2OS manual, ARIA's ArCommands, MobileSim's own from 224 on). */
public final class P2osCommandNumber {
    public static final int PULSE = 0;
    public static final int OPEN = 1;
    public static final int CLOSE = 2;
    public static final int POLLING = 3;
    public static final int ENABLE = 4;
    public static final int SETA = 5;
    public static final int SETV = 6;
    public static final int SETO = 7;
    public static final int MOVE = 8;
    public static final int ROTATE = 9;
    public static final int SETRV = 10;
    public static final int VEL = 11;
    public static final int HEAD = 12;
    public static final int DHEAD = 13;
    public static final int CONFIG = 18;
    public static final int ENCODER = 19;
    public static final int RVEL = 21;
    public static final int DCHEAD = 22;
    public static final int SETRA = 23;
    public static final int SONAR = 28;
    public static final int STOP = 29;
    public static final int VEL2 = 32;
    public static final int LASER = 35;
    public static final int LASER_START = 36;
    public static final int LASER_END = 37;
    public static final int LASER_STEP = 38;
    public static final int BUMPSTALL = 44;
    public static final int E_STOP = 55;
    public static final int E_STOP_OLD = 57;
    public static final int SIM_SET_POSE = 224;
    public static final int SIM_RESET = 225;
    public static final int SIM_LRF_ENABLE = 230;
    public static final int SIM_LRF_START = 231;
    public static final int SIM_LRF_END = 232;
    public static final int SIM_LRF_STEP = 233;
    public static final int SIM_CTRL = 236;
    public static final int SIM_STAT = 237;
    public static final int SIM_MESSAGE = 238;
    public static final int BATTEST = 250;
    /** Answer to a step of the handshake that is out of order: the client starts over. */
    public static final int OUT_OF_ORDER = 255;

    private P2osCommandNumber() {}
}
