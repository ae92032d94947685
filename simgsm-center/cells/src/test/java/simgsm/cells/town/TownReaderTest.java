package simgsm.cells.town;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class TownReaderTest {
    private static final String TOWER = "tower A 0 0 arfcn=20 bsic=11 lac=1\n";

    @Test
    void aTowerWithoutSettingsGetsTheUsualOnes() throws Exception {
        Town town = TownReader.read("t.town", TOWER);

        assertEquals("t", town.name());
        assertEquals(
                List.of(new Tower("A", new TownPlace(0, 0), 30, 43, 20, 11, 1, 6969, 6969, 6, CellSelection.STANDARD)),
                town.towers());
    }

    @Test
    void aByteOrderMarkIsNoPartOfTheFileAndOtherAlphabetsAreRefused(@TempDir Path folder) throws Exception {
        Path file = Files.writeString(folder.resolve("t.town"), "\uFEFF" + TOWER);
        assertEquals(1, TownFile.read(file).towers().size());

        Files.writeString(file, TOWER + "town Caba\u00F1as\n", StandardCharsets.ISO_8859_1);
        IOException refused = assertThrows(IOException.class, () -> TownFile.read(file));
        assertEquals(file + ": line 2, octet 10: expected UTF-8, found F1", refused.getMessage());
    }

    @Test
    void everyObjectAndSettingIsRead() throws Exception {
        Town town = TownReader.read("t.town", """
                # a remark
                town By the sea   # another
                size 2000 1000 -500 -250
                area metropolitan
                shadow 8 40
                timeout 32
                tower A 10 -20.5 height=40 power=46.5 arfcn=512 bsic=63 lac=7 cell=9 site=5 tch=2 access=10 hysteresis=6 \
                offset=20 temporary=10 penalty=40
                building hall 10 30 0 20 loss=25
                hill top 100 100 radius=50 height=20
                mobile 5550100 5 6
                walk way 0 0 10 0 10 10 speed=2 number=5550101
                """);

        assertEquals("By the sea", town.name());
        assertEquals(-500, town.westMetres());
        assertEquals(-250, town.southMetres());
        assertEquals(2000, town.widthMetres());
        assertEquals(1000, town.heightMetres());
        assertEquals(Clutter.METROPOLITAN, town.surroundings());
        assertEquals(8, town.shadowDecibels());
        assertEquals(40, town.shadowMetres());
        assertEquals(32, town.radioLinkTimeout());
        CellSelection selection = new CellSelection(10, 6, 20, 10, 40);
        assertEquals(
                List.of(new Tower("A", new TownPlace(10, -20.5), 40, 46.5, 512, 63, 7, 9, 5, 2, selection)),
                town.towers());
        assertEquals(List.of(new Building("hall", 0, 20, 10, 30, 25)), town.buildings());
        assertEquals(List.of(new Hill("top", new TownPlace(100, 100), 50, 20)), town.hills());
        assertEquals(new TownPlace(5, 6), town.start("5550100"));
        assertEquals(new TownPlace(0, 0), town.start("5550101"));
        assertEquals(new TownPlace(500, 250), town.start("5550102"));
        assertEquals(20, town.walk("way").orElseThrow().lengthMetres());
        assertEquals("way", town.walkOf("5550101").orElseThrow().name());
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '~',
            value = {
                "house 1 2|\"house\"|town, size, area, shadow, timeout, tower, building, hill, mobile or walk",
                "tower B|the line's end|x of the tower in metres",
                "tower B 1 north|\"north\"|y of the tower in metres, a number",
                "tower B 1 2 bsic=1 lac=1|no arfcn=|arfcn=0 to 1023",
                "tower B 1 2 arfcn=200 bsic=1 lac=1|arfcn=200|an ARFCN of 0 to 124, 512 to 885 or 975 to 1023",
                "tower B 1 2 arfcn=21 bsic=64 lac=1|\"64\"|bsic, 0 to 63",
                "tower B 1 2 arfcn=21 bsic=1.5 lac=1|\"1.5\"|bsic, a whole number",
                "tower B 1 2 arfcn=21 bsic=1 lac=0|\"0\"|lac, 1 to 65533",
                "tower B 1 2 arfcn=21 bsic=1 lac=1 hysteresis=3|\"3\"|hysteresis, 0 to 14 in steps of 2",
                "tower B 1 2 arfcn=21 bsic=1 lac=1 colour=red|\"colour=\"|one of [height, power,",
                "tower B 1 2 arfcn=21 arfcn=22 bsic=1 lac=1|a second arfcn=|each setting once",
                "tower B 1 2 arfcn=21 9 bsic=1 lac=1|\"9\"|a setting KEY=VALUE",
                "tower A 1 2 arfcn=21 bsic=1 lac=1|a second tower \"A\"|a name of its own for each tower",
                "tower B 1 2 arfcn=20 bsic=11 lac=2|arfcn=20 bsic=11 of tower A again|another ARFCN or BSIC",
                "tower B 1 2 arfcn=21 bsic=11 lac=1 cell=6969|cell=6969 of tower A again|a cell identity once",
                "tower B 1 2 arfcn=21 bsic=11 lac=2 site=6969|site=6969 of tower A again|a site once",
                "size 0 10|\"0\"|the width in metres, 1 to 100000",
                "area forest|\"forest\"|metropolitan, urban, suburban or open",
                "timeout 10|\"10.0\"|SACCH blocks, 4 to 64 in steps of 4",
                "mobile anna 0 0|\"anna\"|a telephone number of 1 to 15 digits",
                "walk w 0 0|1 points|at least two points X Y",
                "walk w 5 5 5 5|points at one place|a walk of at least 1 m",
                "walk w 0 0 1|the line's end|y of point 2 in metres",
                "shadow NaN|\"NaN\"|the standard deviation in dB, a finite number",
                "building b 0 0 1 1 2|\"2\"|settings of [loss]",
            })
    void aWrongLineIsRefusedWithItsNumberWhatWasFoundAndWhatWasExpected(String line, String found, String expected) {
        TownFormatException refusal =
                assertThrows(TownFormatException.class, () -> TownReader.read("t.town", TOWER + line + "\n"));

        assertEquals(2, refusal.line());
        String start = "t.town:2: found " + found + ", expected " + expected;
        assertTrue(refusal.getMessage().startsWith(start), refusal.getMessage());
    }

    @Test
    void aTownWithoutTowersIsRefused() {
        TownFormatException refusal =
                assertThrows(TownFormatException.class, () -> TownReader.read("t.town", "town Nothing\n"));

        assertEquals(
                "t.town:1: found no tower, expected a line \"tower NAME X Y arfcn=N bsic=N lac=N\"",
                refusal.getMessage());
    }

    @ParameterizedTest
    @ValueSource(strings = {"village", "city", "tunnel"})
    void everyTownOfTheSuiteIsReadAndHoldsItsTowersAndWalks(String name) throws Exception {
        Town town = TownFile.read(Path.of("../../worlds", name + ".town"));

        for (Tower tower : town.towers()) {
            TownPlace place = tower.place();
            assertEquals(place, town.within(place.xMetres(), place.yMetres()));
        }
        for (Walk walk : town.walks()) {
            walk.points().forEach(point -> assertEquals(point, town.within(point.xMetres(), point.yMetres())));
        }
        assertEquals(name.equals("city") ? 7 : 2, town.towers().size());
        assertEquals(
                name.equals("city") ? 2 : 1,
                town.towers().stream().map(Tower::area).distinct().count());
    }
}
