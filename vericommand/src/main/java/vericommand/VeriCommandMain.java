package vericommand;

/** Starts the program from the command line. */
public final class VeriCommandMain {
    private VeriCommandMain() {}

    public static void main(String[] args) {
        System.exit(2);
    }
}
