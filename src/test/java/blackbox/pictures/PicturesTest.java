package blackbox.pictures;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import blackbox.Dist;
import java.awt.Color;
import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.ResourceLock;
import simgsm.draw.Appearance;
import simgsm.ui.Theme;

@ResourceLock("the theme, which is one for the process")
class PicturesTest {
    @Test
    void aSessionIsPaintedAlikeAtEveryRun() throws Exception {
        assertArrayEquals(painted(), painted());
    }

    private static int[] painted() throws Exception {
        Theme.install(Appearance.LIGHT, 1);
        FilmedSession session = new FilmedSession(Dist.root().resolve("worlds"), Locale.ENGLISH, picture -> {});
        session.dial();
        session.press("**", 0.2);
        BufferedImage[] image = new BufferedImage[1];
        session.onEventThread(() -> image[0] = session.picture().all(1));
        return image[0].getRGB(0, 0, image[0].getWidth(), image[0].getHeight(), null, 0, image[0].getWidth());
    }

    @Test
    void anAnimatedPictureHoldsWhatWasAdded(@TempDir Path folder) throws Exception {
        AnimatedPicture film = new AnimatedPicture(40, 20);
        for (Color ground : List.of(Color.WHITE, Color.WHITE, Color.RED)) {
            BufferedImage image = new BufferedImage(40, 20, BufferedImage.TYPE_INT_RGB);
            for (int x = 10; x < 20; x++) {
                image.setRGB(x, 5, ground.getRGB());
            }
            film.add(image, 0.2);
        }
        Path file = folder.resolve("film.gif");
        film.write(file);
        ImageReader reader = ImageIO.getImageReadersByFormatName("gif").next();
        try (ImageInputStream in = ImageIO.createImageInputStream(file.toFile())) {
            reader.setInput(in);
            assertEquals(2, reader.getNumImages(true), "the same picture again is shown for longer");
            assertEquals(Color.WHITE.getRGB(), reader.read(0).getRGB(10, 5));
            BufferedImage changed = reader.read(1);
            assertEquals(10, changed.getWidth());
            assertEquals(1, changed.getHeight());
            assertEquals(Color.RED.getRGB(), changed.getRGB(0, 0));
        }
    }

    @Test
    void thePicturesOfTheDocumentsAreOurs() throws Exception {
        try (Stream<Path> files = Files.list(Dist.root().resolve("docs/pictures"))) {
            for (Path file : files.toList()) {
                assertTrue(Files.size(file) < 3_000_000, file + " is too large for a page");
                assertTrue(ImageIO.read(file.toFile()).getWidth() > 300, file.toString());
            }
        }
    }
}
