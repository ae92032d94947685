package simgsm.cells.town;

import java.util.ArrayList;
import java.util.DoubleSummaryStatistics;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Reads {@code .town} files: text, one object per line, {@code #} begins a comment; docs/TOWNS.md has the format. */
public final class TownReader {
    /** Maximum of towers in a town; a mobile's list of neighbours holds fewer, but distant towers need none. */
    public static final int TOWERS_MAX = 500;

    private static final double SIDE_MAX_METRES = 100_000;
    private static final double STRIP_METRES = 1_000;
    /** A walk to and fro needs a length. */
    private static final double SHORTEST_WALK_METRES = 1;

    private static final int FIRST_SITE = 6969;
    private static final int LARGEST_16_BIT = 0xFFFF;
    /** LAC 0 and 0xFFFE are reserved (TS 23.003, 4.1). */
    private static final int LAC_MAX = 0xFFFD;

    private String name;
    private Optional<Extent> edges = Optional.empty();
    private Clutter surroundings = Clutter.URBAN;
    private double shadowDecibels = 6;
    private double shadowMetres = 50;
    private int radioLinkTimeout = 16;
    private final List<Tower> towers = new ArrayList<>();
    private final List<Building> buildings = new ArrayList<>();
    private final List<Hill> hills = new ArrayList<>();
    private final List<Walk> walks = new ArrayList<>();
    private final Map<String, TownPlace> starts = new LinkedHashMap<>();

    private TownReader(String source) {
        name = source.replaceFirst("\\.town$", "");
    }

    /**
     * Reads a town from a text.
     *
     * @param source the file's name, for errors; without {@code .town} the default of the town's name
     */
    public static Town read(String source, String text) throws TownFormatException {
        TownReader reader = new TownReader(source);
        List<String> lines = text.lines().toList();
        for (int i = 0; i < lines.size(); i++) {
            String line = lines.get(i).replaceFirst("#.*", "").strip();
            if (!line.isEmpty()) {
                reader.accept(line, new TownLine(source, i + 1, line));
            }
        }
        if (reader.towers.isEmpty()) {
            throw new TownFormatException(
                    source, Math.max(1, lines.size()), "no tower", "a line \"tower NAME X Y arfcn=N bsic=N lac=N\"");
        }
        return reader.town();
    }

    private void accept(String text, TownLine line) throws TownFormatException {
        String kind = line.word("an object");
        switch (kind) {
            case "town" -> name = text.substring(kind.length()).strip();
            case "size" -> size(line);
            case "area" -> area(line);
            case "shadow" -> shadow(line);
            case "timeout" -> timeout(line);
            case "tower" -> tower(line);
            case "building" -> building(line);
            case "hill" -> hill(line);
            case "mobile" -> mobile(line);
            case "walk" -> walk(line);
            default ->
                throw line.fault(
                        TownLine.quoted(kind),
                        "town, size, area, shadow, timeout, tower, building, hill, mobile or walk");
        }
    }

    private void size(TownLine line) throws TownFormatException {
        double width = line.numberIn("the width in metres", 1, SIDE_MAX_METRES);
        double height = line.numberIn("the height in metres", 1, SIDE_MAX_METRES);
        double west = line.hasMore() ? line.numberIn("x of the western edge", -SIDE_MAX_METRES, SIDE_MAX_METRES) : 0;
        double south = line.hasMore() ? line.numberIn("y of the southern edge", -SIDE_MAX_METRES, SIDE_MAX_METRES) : 0;
        edges = Optional.of(new Extent(west, south, west + width, south + height));
        line.end();
    }

    private void area(TownLine line) throws TownFormatException {
        String word = line.word("the surroundings");
        surroundings = Clutter.of(word)
                .orElseThrow(() -> line.fault(TownLine.quoted(word), "metropolitan, urban, suburban or open"));
        line.end();
    }

    private void shadow(TownLine line) throws TownFormatException {
        shadowDecibels = line.numberIn("the standard deviation in dB", 0, 20);
        if (line.hasMore()) {
            shadowMetres = line.numberIn("the correlation in metres", 1, 1_000);
        }
        line.end();
    }

    private void timeout(TownLine line) throws TownFormatException {
        double blocks = line.numberIn("RADIO_LINK_TIMEOUT in SACCH blocks", 4, 64);
        if (blocks % 4 != 0) {
            throw line.fault(TownLine.quoted(Double.toString(blocks)), "SACCH blocks, 4 to 64 in steps of 4");
        }
        radioLinkTimeout = (int) blocks;
        line.end();
    }

    private void tower(TownLine line) throws TownFormatException {
        String tower = line.word("the tower's name");
        TownPlace place = line.point("the tower");
        double height = line.setting("height", 30, 1, 300);
        double power = line.setting("power", 43, -20, 70);
        int arfcn = line.required("arfcn", 0, 1023);
        if (!Frequencies.isChannel(arfcn)) {
            throw line.fault("arfcn=" + arfcn, "an ARFCN of 0 to 124, 512 to 885 or 975 to 1023");
        }
        int bsic = line.required("bsic", 0, 63);
        int area = line.required("lac", 1, LAC_MAX);
        int site = line.whole("site", FIRST_SITE + towers.size(), 0, LARGEST_16_BIT);
        int cell = line.whole("cell", site, 0, LARGEST_16_BIT);
        int channels = line.whole("tch", 6, 1, 7);
        CellSelection selection = selection(line);
        line.end();
        Tower read = new Tower(tower, place, height, power, arfcn, bsic, area, cell, site, channels, selection);
        for (Tower other : towers) {
            requireDistinct(read, other, line);
        }
        if (towers.size() == TOWERS_MAX) {
            throw line.fault("one more tower", "at most " + TOWERS_MAX);
        }
        towers.add(read);
    }

    private static CellSelection selection(TownLine line) throws TownFormatException {
        CellSelection standard = CellSelection.STANDARD;
        return new CellSelection(
                line.whole("access", standard.accessMinimumRxlev(), 0, 63),
                line.whole("hysteresis", standard.hysteresisDecibels(), 0, 14, 2),
                line.whole("offset", standard.offsetDecibels(), 0, 126, 2),
                line.whole("temporary", standard.temporaryOffsetDecibels(), 0, 70, 10),
                line.whole("penalty", standard.penaltySeconds(), 20, 620, 20));
    }

    private static void requireDistinct(Tower tower, Tower other, TownLine line) throws TownFormatException {
        String again = " of tower " + other.name() + " again";
        if (other.name().equals(tower.name())) {
            throw line.fault("a second tower " + TownLine.quoted(tower.name()), "a name of its own for each tower");
        }
        if (other.arfcn() == tower.arfcn() && other.bsic() == tower.bsic()) {
            throw line.fault(
                    "arfcn=" + tower.arfcn() + " bsic=" + tower.bsic() + again,
                    "another ARFCN or BSIC: mobiles know cells apart by the two");
        }
        if (other.site() == tower.site()) {
            throw line.fault("site=" + tower.site() + again, "a site once in the town");
        }
        if (other.area() == tower.area() && other.cellIdentity() == tower.cellIdentity()) {
            throw line.fault("cell=" + tower.cellIdentity() + again, "a cell identity once in a location area");
        }
    }

    private void building(TownLine line) throws TownFormatException {
        String building = line.word("the building's name");
        TownPlace one = line.point("one corner");
        TownPlace other = line.point("the opposite corner");
        double loss = line.setting("loss", 15, 0, 100);
        line.end();
        buildings.add(new Building(
                building,
                Math.min(one.xMetres(), other.xMetres()),
                Math.min(one.yMetres(), other.yMetres()),
                Math.max(one.xMetres(), other.xMetres()),
                Math.max(one.yMetres(), other.yMetres()),
                loss));
    }

    private void hill(TownLine line) throws TownFormatException {
        String hill = line.word("the hill's name");
        TownPlace top = line.point("the top");
        hills.add(new Hill(hill, top, line.setting("radius", 300, 1, 20_000), line.setting("height", 50, 1, 5_000)));
        line.end();
    }

    private void mobile(TownLine line) throws TownFormatException {
        String number = number(line, line.word("the mobile's number"));
        TownPlace at = line.point("the mobile");
        line.end();
        if (starts.put(number, at) != null) {
            throw line.fault("a second place for " + number, "one line for each mobile");
        }
    }

    private static String number(TownLine line, String text) throws TownFormatException {
        if (!text.matches("\\d{1,15}")) {
            throw line.fault(TownLine.quoted(text), "a telephone number of 1 to 15 digits");
        }
        return text;
    }

    private void walk(TownLine line) throws TownFormatException {
        String walk = line.word("the walk's name");
        List<TownPlace> points = new ArrayList<>();
        while (line.hasMore()) {
            points.add(line.point("point " + (points.size() + 1)));
        }
        if (points.size() < 2) {
            throw line.fault(points.size() + " points", "at least two points X Y");
        }
        if (new Walk(walk, "", 1, points).lengthMetres() < SHORTEST_WALK_METRES) {
            throw line.fault("points at one place", "a walk of at least 1 m");
        }
        double speed = line.setting("speed", 1.5, 0.01, 150);
        String number = line.text("number", "");
        line.end();
        if (walks.stream().anyMatch(other -> other.name().equals(walk))) {
            throw line.fault("a second walk " + TownLine.quoted(walk), "a name of its own for each walk");
        }
        walks.add(new Walk(walk, number.isEmpty() ? "" : number(line, number), speed, points));
    }

    /** Builds the town; without a size line it extends 1 km beyond its outermost towers. */
    private Town town() {
        Extent extent = edges.orElseGet(() -> Extent.around(towers, STRIP_METRES));
        return new Town(
                name,
                extent.west,
                extent.south,
                extent.east - extent.west,
                extent.north - extent.south,
                surroundings,
                shadowDecibels,
                shadowMetres,
                radioLinkTimeout,
                towers,
                buildings,
                hills,
                walks,
                starts);
    }

    private record Extent(double west, double south, double east, double north) {
        static Extent around(List<Tower> towers, double stripMetres) {
            DoubleSummaryStatistics x = new DoubleSummaryStatistics();
            DoubleSummaryStatistics y = new DoubleSummaryStatistics();
            for (Tower tower : towers) {
                x.accept(tower.place().xMetres());
                y.accept(tower.place().yMetres());
            }
            return new Extent(
                    x.getMin() - stripMetres,
                    y.getMin() - stripMetres,
                    x.getMax() + stripMetres,
                    y.getMax() + stripMetres);
        }
    }
}
