package simgsm.center;

import java.util.ServiceLoader;

/** Starts the centre (M3) from the command line. */
public final class CenterMain {
    private CenterMain() {}

    public static void main(String[] args) {
        ServiceLoader.load(CenterLauncher.class).findFirst().orElseThrow().launch(args);
    }
}
