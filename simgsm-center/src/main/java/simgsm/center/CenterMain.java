package simgsm.center;

/** Starts the program from the command line. */
public final class CenterMain {
    private CenterMain() {}

    public static void main(String[] args) {
        System.exit(2);
    }
}
