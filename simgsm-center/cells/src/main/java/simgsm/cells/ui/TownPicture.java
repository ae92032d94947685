package simgsm.cells.ui;

import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import simgsm.cells.snapshot.CellState;
import simgsm.cells.snapshot.MobileState;
import simgsm.cells.snapshot.TownSnapshot;
import simgsm.cells.town.Building;
import simgsm.cells.town.Hill;
import simgsm.cells.town.Tower;
import simgsm.cells.town.Town;
import simgsm.cells.town.TownPlace;
import simgsm.cells.town.Walk;
import simgsm.console.TextBundle;
import simgsm.draw.Canvas;
import simgsm.draw.Face;
import simgsm.draw.Ink;
import simgsm.draw.Outline;
import simgsm.draw.StatusMark;

/** Draws a town's objects and mobiles over its coverage. */
final class TownPicture {
    /** Radius of a mobile, in units. */
    static final double MOBILE_UNITS = 7;
    /** Height of a mast, in units. */
    static final double MAST_UNITS = 26;

    private static final double CHIP_HEIGHT_UNITS = 17;
    /** Minimum width of the map per tower for its second line. */
    private static final double DETAIL_UNITS = 170;

    private static final double CHIP_PADDING_UNITS = 4;

    private final TownSnapshot snapshot;
    private final MapScale scale;
    private final TextBundle texts;
    private final Canvas g;
    private final Map<String, Integer> towerIndices = new HashMap<>();
    private final MapLabels labels;

    TownPicture(TownSnapshot snapshot, MapScale scale, TextBundle texts, Canvas g) {
        this.snapshot = snapshot;
        this.scale = scale;
        this.texts = texts;
        this.g = g;
        labels = new MapLabels(new Rectangle2D.Double(scale.left(), scale.top(), scale.width(), scale.height()));
        List<Tower> towers = snapshot.town().towers();
        for (int i = 0; i < towers.size(); i++) {
            towerIndices.put(towers.get(i).name(), i);
        }
    }

    /**
     * Draws everything.
     *
     * @param selected number of the marked mobile
     * @param showsPaths true to show the town's walks
     * @param drawn the path being drawn; may be empty
     */
    void draw(Optional<String> selected, boolean showsPaths, List<TownPlace> drawn) {
        snapshot.town().hills().forEach(this::rings);
        snapshot.town().buildings().forEach(this::building);
        if (showsPaths) {
            snapshot.town().walks().forEach(this::walk);
        }
        for (MobileState mobile : snapshot.mobiles()) {
            path(mobile, selected.filter(mobile.number()::equals).isPresent());
            connection(mobile);
        }
        path(drawn, Ink.ACCENT);
        snapshot.town().hills().forEach(this::name);
        if (showsPaths) {
            nameWalks();
        }
        snapshot.mobiles().forEach(this::take);
        for (int i = 0; i < snapshot.cells().size(); i++) {
            tower(snapshot.town().towers().get(i), snapshot.cells().get(i), i);
        }
        scaleBar();
        for (MobileState mobile : snapshot.mobiles()) {
            mobile(mobile, selected.filter(mobile.number()::equals).isPresent());
        }
        snapshot.mobiles().forEach(this::number);
    }

    private void rings(Hill hill) {
        double x = scale.x(hill.top().xMetres());
        double y = scale.y(hill.top().yMetres());
        g.ink(Ink.QUIET, 0.6);
        g.pen(1, 3);
        for (int ring = 1; ring <= 3; ring++) {
            g.draw(Outline.circle(x, y, hill.radiusMetres() * ring / 3 * scale.pixelsPerMetre()));
        }
    }

    private void name(Hill hill) {
        String text = hill.name() + " " + Math.round(hill.heightMetres()) + " m";
        chip(text, Face.SMALL, scale.x(hill.top().xMetres()), scale.y(hill.top().yMetres()), Optional.empty());
    }

    private void building(Building building) {
        double x = scale.x(building.westMetres());
        double y = scale.y(building.northMetres());
        double width = (building.eastMetres() - building.westMetres()) * scale.pixelsPerMetre();
        double height = (building.northMetres() - building.southMetres()) * scale.pixelsPerMetre();
        g.ink(Ink.WALL, 0.28);
        g.bar(x, y, width, height);
        g.ink(Ink.WALL, 0.7);
        g.pen(1);
        g.draw(Outline.box(x, y, width, height));
        g.ink(Ink.TEXT);
        g.text(building.name(), Face.SMALL, x + width / 2, y + height + g.px(9));
    }

    private void walk(Walk walk) {
        path(walk.points(), Ink.QUIET);
    }

    /** Writes each name at the point of its walk that is farthest from other names. */
    private void nameWalks() {
        Town town = snapshot.town();
        List<TownPlace> named = new ArrayList<>();
        town.towers().forEach(tower -> named.add(tower.place()));
        town.hills().forEach(hill -> named.add(hill.top()));
        town.buildings()
                .forEach(building -> named.add(new TownPlace(
                        (building.westMetres() + building.eastMetres()) / 2,
                        (building.southMetres() + building.northMetres()) / 2)));
        for (Walk walk : town.walks()) {
            TownPlace best = quarters(walk.points()).stream()
                    .max(Comparator.comparingDouble(place -> named.stream()
                            .mapToDouble(other -> apart(place, other))
                            .min()
                            .orElse(0)))
                    .orElseThrow();
            named.add(best);
            chip(walk.name(), Face.SMALL, scale.x(best.xMetres()), scale.y(best.yMetres()), Optional.empty());
        }
    }

    /** Distance of names, which are wider than high. */
    private static double apart(TownPlace one, TownPlace other) {
        return Math.hypot(one.xMetres() - other.xMetres(), 2 * (one.yMetres() - other.yMetres()));
    }

    /** The points at a quarter, a half and three quarters of each part. */
    private static List<TownPlace> quarters(List<TownPlace> points) {
        List<TownPlace> places = new ArrayList<>();
        for (int i = 1; i < points.size(); i++) {
            TownPlace from = points.get(i - 1);
            double length = from.distanceMetres(points.get(i));
            for (double part : new double[] {0.5, 0.25, 0.75}) {
                places.add(from.towards(points.get(i), part * length));
            }
        }
        return places;
    }

    private void path(MobileState mobile, boolean isSelected) {
        if (isSelected && !mobile.path().isEmpty()) {
            double[] xy = pixels(mobile.path());
            double[] all = new double[xy.length + 2];
            all[0] = scale.x(mobile.place().xMetres());
            all[1] = scale.y(mobile.place().yMetres());
            System.arraycopy(xy, 0, all, 2, xy.length);
            g.ink(Ink.ACCENT);
            g.pen(1.6, 4);
            g.draw(Outline.polyline(all));
        }
    }

    private void path(List<TownPlace> points, Ink ink) {
        if (points.size() > 1) {
            g.ink(ink, 0.8);
            g.pen(1.4, 4);
            g.draw(Outline.polyline(pixels(points)));
        }
    }

    private double[] pixels(List<TownPlace> points) {
        double[] xy = new double[2 * points.size()];
        for (int i = 0; i < points.size(); i++) {
            xy[2 * i] = scale.x(points.get(i).xMetres());
            xy[2 * i + 1] = scale.y(points.get(i).yMetres());
        }
        return xy;
    }

    /** Draws a line from a mobile to its tower: solid in a connection, dashed if it only listens. */
    private void connection(MobileState mobile) {
        Integer index = towerIndices.get(mobile.cell());
        if (index != null) {
            TownPlace mast = snapshot.town().towers().get(index).place();
            g.ink(CellInk.of(index));
            if (mobile.state() == MobileState.State.IDLE) {
                g.pen(1, 3);
            } else {
                g.pen(2);
            }
            g.line(
                    scale.x(mobile.place().xMetres()),
                    scale.y(mobile.place().yMetres()),
                    scale.x(mast.xMetres()),
                    scale.y(mast.yMetres()) - g.px(MAST_UNITS));
        }
    }

    private void tower(Tower tower, CellState state, int index) {
        double x = scale.x(tower.place().xMetres());
        double foot = scale.y(tower.place().yMetres());
        double top = foot - g.px(MAST_UNITS);
        double half = g.px(6);
        Ink ink = state.isOn() ? Ink.TEXT : Ink.QUIET;
        g.ink(ink);
        g.pen(1.6);
        g.draw(Outline.polyline(x - half, foot, x, top, x + half, foot));
        g.draw(Outline.polyline(x - half * 0.62, foot - g.px(10), x + half * 0.62, foot - g.px(10)));
        g.draw(Outline.polyline(x - half * 0.32, foot - g.px(18), x + half * 0.32, foot - g.px(18)));
        StatusMark mark = state.isOn() ? StatusMark.DISC : StatusMark.SLASHED_RING;
        mark.draw(g, x, top, g.px(4.5), state.isOn() ? CellInk.of(index) : Ink.QUIET);
        String detail = state.isOn()
                ? texts.of(
                        "map.tower",
                        String.valueOf(tower.arfcn()),
                        String.valueOf(state.freeChannels()),
                        String.valueOf(state.channels()))
                : texts.of("tower.off");
        boolean isDetailed = scale.width() / Math.sqrt(snapshot.cells().size()) >= g.px(DETAIL_UNITS);
        double row = g.px(17);
        double wide = g.px(5) + 2 * g.px(CHIP_PADDING_UNITS) + g.width(tower.name(), Face.STRONG);
        wide = isDetailed ? Math.max(wide, 2 * g.px(CHIP_PADDING_UNITS) + g.width(detail, Face.MONO_SMALL)) : wide;
        Rectangle2D place = towerNames(x, top, foot, wide, isDetailed ? 2 * row : row);
        chip(tower.name(), Face.STRONG, place.getCenterX(), place.getY() + row / 2, Optional.of(CellInk.of(index)));
        if (isDetailed) {
            chip(detail, Face.MONO_SMALL, place.getCenterX(), place.getY() + row * 1.5, Optional.empty());
        }
    }

    /** Below the mast, or where it covers no mobile: above, at the right, at the left. */
    private Rectangle2D towerNames(double x, double top, double foot, double width, double height) {
        double aside = g.px(14);
        return labels.place(List.of(
                new Rectangle2D.Double(x - width / 2, foot + g.px(3.5), width, height),
                new Rectangle2D.Double(x - width / 2, top - g.px(8) - height, width, height),
                new Rectangle2D.Double(x + aside, foot - height, width, height),
                new Rectangle2D.Double(x - aside - width, foot - height, width, height)));
    }

    private void mobile(MobileState mobile, boolean isSelected) {
        double x = scale.x(mobile.place().xMetres());
        double y = scale.y(mobile.place().yMetres());
        double radius = g.px(MOBILE_UNITS);
        g.ink(Ink.CARD);
        g.fill(Outline.circle(x, y, radius + g.px(2)));
        if (isSelected) {
            g.ink(Ink.ACCENT);
            g.pen(2);
            g.draw(Outline.circle(x, y, radius + g.px(5)));
        }
        markOf(mobile.state()).draw(g, x, y, radius, Ink.TEXT);
        if (mobile.isCiphered()) {
            StatusMark.LOCK.draw(g, x + radius * 1.6, y - radius, radius * 0.7, Ink.TEXT);
        }
    }

    private void take(MobileState mobile) {
        double radius = g.px(MOBILE_UNITS);
        labels.take(new Rectangle2D.Double(
                scale.x(mobile.place().xMetres()) - radius,
                scale.y(mobile.place().yMetres()) - radius,
                2 * radius,
                2 * radius));
    }

    /**
     * Writes the number below its mobile, or where it covers no other name: above, at the side, or a row further away.
     */
    private void number(MobileState mobile) {
        double x = scale.x(mobile.place().xMetres());
        double y = scale.y(mobile.place().yMetres());
        double width = g.width(mobile.number(), Face.MONO_SMALL) + 2 * g.px(CHIP_PADDING_UNITS);
        double height = g.px(CHIP_HEIGHT_UNITS);
        double below = y + g.px(MOBILE_UNITS + 12) - height / 2;
        double above = y - g.px(MOBILE_UNITS + 12) - height / 2;
        double aside = width / 2 + g.px(MOBILE_UNITS + 6);
        double left = x - width / 2;
        List<Rectangle2D> places = new ArrayList<>();
        for (double[] corner : new double[][] {
            {left, below},
            {left, above},
            {left + aside, y - height / 2},
            {left - aside, y - height / 2},
            {left + aside, above},
            {left - aside, above},
            {left, above - height},
            {left, below + 2 * height}
        }) {
            places.add(new Rectangle2D.Double(corner[0], corner[1], width, height));
        }
        Rectangle2D place = labels.place(places);
        chip(mobile.number(), Face.MONO_SMALL, place, Optional.empty());
    }

    static StatusMark markOf(MobileState.State state) {
        return switch (state) {
            case SEARCHING -> StatusMark.SLASHED_RING;
            case IDLE -> StatusMark.RING;
            case DEDICATED -> StatusMark.DISC;
            case HANDOVER -> StatusMark.HALF_DISC;
        };
    }

    /** Draws a text on a card, with the colour of its cell at the left. */
    private void chip(String text, Face face, double x, double y, Optional<Ink> cell) {
        double width = g.width(text, face) + 2 * g.px(CHIP_PADDING_UNITS) + stripe(cell);
        double height = g.px(CHIP_HEIGHT_UNITS);
        double left = Math.max(scale.left(), Math.min(scale.left() + scale.width() - width, x - width / 2));
        Rectangle2D card = new Rectangle2D.Double(left, y - height / 2, width, height);
        labels.take(card);
        chip(text, face, card, cell);
    }

    private void chip(String text, Face face, Rectangle2D card, Optional<Ink> cell) {
        g.ink(Ink.CARD, 0.85);
        g.fill(Outline.round(card.getX(), card.getY(), card.getWidth(), card.getHeight(), g.px(4)));
        double stripe = stripe(cell);
        cell.ifPresent(ink -> {
            g.ink(ink);
            g.bar(card.getX(), card.getY(), stripe, card.getHeight());
        });
        g.ink(Ink.TEXT);
        g.text(text, face, card.getX() + stripe + (card.getWidth() - stripe) / 2, card.getCenterY());
    }

    private double stripe(Optional<Ink> cell) {
        return cell.isPresent() ? g.px(5) : 0;
    }

    /** Draws a length of 1, 2 or 5 times a power of ten, about a sixth of the picture. */
    private void scaleBar() {
        Town town = snapshot.town();
        double wanted = town.widthMetres() / 6;
        double metres = Math.pow(10, Math.floor(Math.log10(wanted)));
        metres *= wanted >= 5 * metres ? 5 : wanted >= 2 * metres ? 2 : 1;
        double length = metres * scale.pixelsPerMetre();
        double x = scale.left() + g.px(12);
        double y = scale.top() + scale.height() - g.px(12);
        g.ink(Ink.CARD, 0.85);
        g.fill(Outline.round(x - g.px(6), y - g.px(18), length + g.px(12), g.px(24), g.px(4)));
        labels.take(new Rectangle2D.Double(x - g.px(6), y - g.px(18), length + g.px(12), g.px(24)));
        g.ink(Ink.TEXT);
        g.pen(1.4);
        g.draw(Outline.polyline(x, y - g.px(4), x, y, x + length, y, x + length, y - g.px(4)));
        String text = metres >= 1_000 ? Math.round(metres / 1_000) + " km" : Math.round(metres) + " m";
        g.text(text, Face.SMALL, x + length / 2, y - g.px(8));
    }
}
