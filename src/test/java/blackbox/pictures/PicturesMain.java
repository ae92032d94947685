package blackbox.pictures;

import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.function.Supplier;
import javax.imageio.ImageIO;
import javax.swing.SwingUtilities;
import simgsm.draw.Appearance;
import simgsm.ui.Theme;

/** Paints the documents' pictures anew. Argument: the source tree. */
public final class PicturesMain {
    private static final Locale SPANISH = Locale.forLanguageTag("es");
    private static final double FILM_SCALE = 0.6;

    private final Path worlds;
    private final Path pictures;

    private PicturesMain(Path root) throws IOException {
        worlds = root.resolve("worlds");
        pictures = Files.createDirectories(root.resolve("docs/pictures"));
    }

    public static void main(String[] arguments) throws Exception {
        int status = 1;
        try {
            new PicturesMain(Path.of(arguments[0])).paint();
            status = 0;
        } catch (IllegalStateException | IOException e) {
            e.printStackTrace();
        }
        // The panels' threads would hold the process.
        System.exit(status);
    }

    private void paint() throws Exception {
        film();
        still();
        for (Appearance appearance : Appearance.values()) {
            theme(appearance);
        }
    }

    /** The session of 20 s at the top of README. */
    private void film() throws Exception {
        dress(Appearance.LIGHT);
        AnimatedPicture film = new AnimatedPicture(
                (int) Math.round(SuitePicture.WIDTH * FILM_SCALE), (int) Math.round(SuitePicture.HEIGHT * FILM_SCALE));
        FilmedSession session = new FilmedSession(
                worlds,
                Locale.ENGLISH,
                picture -> film.add(halved(picture.all(2 * FILM_SCALE)), FilmedSession.SECONDS_PER_PICTURE));
        session.dial();
        session.press("** #**50 **", 3.4);
        session.press("** #*#90 **", 2.6);
        session.press("** #**200 **", 4);
        session.hangUp();
        film.write(pictures.resolve("session.gif"));
    }

    private void still() throws Exception {
        dress(Appearance.LIGHT);
        FilmedSession session = new FilmedSession(worlds, Locale.ENGLISH, picture -> {});
        SuitePicture picture = session.picture();
        write(session, "phone.png", picture::phone);
        session.dial();
        session.press("** #**50 **", 0.6);
        write(session, "windows.png", () -> picture.all(1));
        session.onEventThread(() -> {
            picture.handset().setScopeOpen(true);
            picture.arrangePhone(960);
        });
        write(session, "phone-scope.png", picture::phone);
        session.onEventThread(() -> {
            picture.handset().setScopeOpen(false);
            picture.arrangeRobot(1_200, 800);
        });
        write(session, "robot.png", picture::robot);
        session.press("", 3);
        session.hangUp();
        session.message("** #*#90 #**20 **", 6);
        session.onEventThread(() -> picture.arrangeCenter(1_200, 760));
        session.onEventThread(picture::refresh);
        write(session, "centre.png", picture::center);
        write(session, "phone-message.png", picture::phone);
    }

    private void theme(Appearance appearance) throws Exception {
        dress(appearance);
        FilmedSession session = new FilmedSession(worlds, SPANISH, picture -> {});
        session.dial();
        session.press("** #**50 **", 0.6);
        write(
                session,
                "theme-" + appearance.word() + ".png",
                () -> halved(session.picture().all(1)));
    }

    /** Half the size: letters keep their shapes, which small fonts have not. */
    private static BufferedImage halved(BufferedImage image) {
        BufferedImage half = new BufferedImage(image.getWidth() / 2, image.getHeight() / 2, BufferedImage.TYPE_INT_RGB);
        Graphics2D g = half.createGraphics();
        g.setRenderingHint(RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BILINEAR);
        g.drawImage(image, 0, 0, half.getWidth(), half.getHeight(), null);
        g.dispose();
        return half;
    }

    private static void dress(Appearance appearance) throws Exception {
        SwingUtilities.invokeAndWait(() -> Theme.install(appearance, 1));
    }

    private void write(FilmedSession session, String name, Supplier<BufferedImage> painted) throws IOException {
        BufferedImage[] image = new BufferedImage[1];
        session.onEventThread(() -> image[0] = painted.get());
        ImageIO.write(image[0], "png", pictures.resolve(name).toFile());
    }
}
