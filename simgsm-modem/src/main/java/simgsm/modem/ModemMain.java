package simgsm.modem;

/** Starts the program from the command line. */
public final class ModemMain {
    private ModemMain() {}

    public static void main(String[] args) {
        System.exit(2);
    }
}
