package simgsm.cells.ui;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simgsm.cells.snapshot.MobileState;
import simgsm.cells.town.TownPlace;
import simgsm.draw.Ink;
import simgsm.draw.SvgCanvas;

/** What is drawn of a town can be read. */
class TownPictureTest {
    private static final Pattern TEXT = Pattern.compile(
            "<text x=\"([-0-9.]+)\" y=\"([-0-9.]+)\".* font-family=\"([a-z-]+)\" font-size=\"([0-9.]+)\".*>(.*)</text>");

    private record Written(String text, Rectangle2D box) {}

    /** A text's box, 0.6 of its size a letter. */
    private static List<Written> written(String svg) {
        List<Written> all = new ArrayList<>();
        Matcher match = TEXT.matcher(svg);
        while (match.find()) {
            double size = Double.parseDouble(match.group(4));
            double width = 0.6 * size * match.group(5).length();
            double left = Double.parseDouble(match.group(1)) - width / 2;
            double top = Double.parseDouble(match.group(2)) - 0.73 * size;
            all.add(new Written(match.group(5), new Rectangle2D.Double(left, top, width, 0.73 * size)));
        }
        return all;
    }

    /** In a lesson on a screen of 1024x768 the map of the avenue is 307 pixels wide. */
    @ParameterizedTest
    @CsvSource({"avenue, 340, 380", "avenue, 720, 520", "village, 307, 340", "village, 720, 520", "city, 720, 520"})
    void aMobilesNumberCoversNoOtherName(String town, int width, int height) throws Exception {
        SampleTown sample = new SampleTown(town);
        MapScale scale = MapScale.fitting(sample.town, width, height);
        SvgCanvas canvas = new SvgCanvas(Ink::name);
        new TownPicture(sample.snapshot(), scale, TownWindow.texts(Locale.ENGLISH), canvas)
                .draw(Optional.of(SampleTown.PHONE), true, List.of());
        List<Written> names = written(canvas.elements());
        for (MobileState mobile : sample.snapshot().mobiles()) {
            List<Written> numbers = names.stream()
                    .filter(name -> name.text().equals(mobile.number()))
                    .toList();
            assertEquals(1, numbers.size());
            for (Written other : names) {
                assertFalse(
                        other != numbers.get(0)
                                && other.box().intersects(numbers.get(0).box()),
                        mobile.number() + " covers " + other.text());
            }
        }
    }

    @Test
    void aTowersNameGivesWayToTheMobileBelowItsMast() throws Exception {
        SampleTown sample = new SampleTown("avenue");
        MapScale scale = MapScale.fitting(sample.town, 720, 520);
        TownPlace mast = sample.town.towers().get(0).place();
        TownPlace far = new TownPlace(mast.xMetres() + 700, mast.yMetres() + 700);
        sample.place(SampleTown.PHONE, far);
        sample.place(SampleTown.ROBOT, far);
        double before = nameOf(sample, scale, "west").getMinY();
        assertTrue(before > scale.y(mast.yMetres()));
        sample.place(SampleTown.ROBOT, new TownPlace(mast.xMetres(), mast.yMetres() - 12 / scale.pixelsPerMetre()));
        assertTrue(nameOf(sample, scale, "west").getMinY() < scale.y(mast.yMetres()));
    }

    private static Rectangle2D nameOf(SampleTown sample, MapScale scale, String tower) {
        SvgCanvas canvas = new SvgCanvas(Ink::name);
        new TownPicture(sample.snapshot(), scale, TownWindow.texts(Locale.ENGLISH), canvas)
                .draw(Optional.empty(), true, List.of());
        return written(canvas.elements()).stream()
                .filter(each -> each.text().equals(tower))
                .findFirst()
                .orElseThrow()
                .box();
    }
}
