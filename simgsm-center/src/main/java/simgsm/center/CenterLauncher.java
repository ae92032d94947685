package simgsm.center;

/** Runs the centre's command line; the module above the centre provides it with the demo and the lessons. */
public interface CenterLauncher {
    /** Runs the program; it ends the process. */
    void launch(String... args);
}
