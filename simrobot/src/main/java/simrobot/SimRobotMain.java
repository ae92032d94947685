package simrobot;

/** Starts the program from the command line. */
public final class SimRobotMain {
    private SimRobotMain() {}

    public static void main(String[] args) {
        System.exit(2);
    }
}
