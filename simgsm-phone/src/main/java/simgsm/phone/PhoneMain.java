package simgsm.phone;

/** Starts the program from the command line. */
public final class PhoneMain {
    private PhoneMain() {}

    public static void main(String[] args) {
        System.exit(2);
    }
}
