package blackbox.pictures;

import blackbox.VirtualPhone;
import blackbox.VirtualSuite;
import java.io.IOException;
import java.lang.reflect.InvocationTargetException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.function.Consumer;
import javax.swing.SwingUtilities;
import simrobot.world.WorldReader;

/** The session of the pictures: a call with two orders and a collision, and an order by message. */
final class FilmedSession {
    static final double SECONDS_PER_PICTURE = 0.2;
    private static final int RINGING_MILLIS = 1_000;

    private final VirtualSuite suite;
    private final VirtualPhone phone;
    private final SuitePicture picture;
    private final Consumer<SuitePicture> taken;

    /**
     * Not on the event thread.
     *
     * @param worlds the folder of worlds
     * @param taken run on the event thread every 0.2 s of the session, when the windows show its state
     */
    FilmedSession(Path worlds, Locale language, Consumer<SuitePicture> taken) throws IOException {
        suite = new VirtualSuite(WorldReader.read(worlds.resolve("demo.map")), RINGING_MILLIS, language);
        phone = suite.phone(VirtualSuite.PHONE);
        this.taken = taken;
        SuitePicture[] made = new SuitePicture[1];
        onEventThread(() -> {
            made[0] = new SuitePicture(suite, phone, language);
            made[0].arrange();
        });
        picture = made[0];
        run(1);
    }

    SuitePicture picture() {
        return picture;
    }

    void dial() {
        phone.dial(VirtualSuite.ROBOT);
        run(2.6);
    }

    void press(String keys, double secondsAfter) {
        phone.begin(keys);
        run(keys.replace(" ", "").length() * 0.2 + secondsAfter);
    }

    void hangUp() {
        phone.hangUp();
        run(1);
    }

    void message(String text, double secondsAfter) {
        phone.message(VirtualSuite.ROBOT, text);
        run(secondsAfter);
    }

    /** Performs an act on the event thread, then all that it has left for later, such as layout and scrolling. */
    void onEventThread(Runnable act) {
        try {
            SwingUtilities.invokeAndWait(act);
            SwingUtilities.invokeAndWait(() -> {});
        } catch (InterruptedException | InvocationTargetException e) {
            throw new IllegalStateException(e);
        }
    }

    private void run(double seconds) {
        for (int i = 0; i < Math.round(seconds / SECONDS_PER_PICTURE); i++) {
            onEventThread(() -> {
                suite.seconds(SECONDS_PER_PICTURE);
                picture.refresh();
                picture.arrange();
                picture.refresh();
            });
            onEventThread(() -> taken.accept(picture));
        }
    }
}
