package simgsm.cells.ui;

import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Executor;
import simgsm.cells.radio.LossRaster;
import simgsm.cells.radio.Propagation;
import simgsm.cells.radio.TowerState;
import simgsm.cells.snapshot.CellState;
import simgsm.cells.snapshot.TownSnapshot;
import simgsm.draw.Appearance;

/** Updates the coverage's picture. A worker computes it; the old picture is shown meanwhile. */
final class CoverageView {
    /** Minimum width of the raster's squares, device pixels. */
    private static final double SQUARE_PIXELS = 3;
    /** Maximum of columns; beyond it the picture is enlarged to save time. */
    private static final double COLUMNS_MAX = 400;

    /** The properties that determine a picture. */
    private record Look(
            double squareMetres,
            List<TowerState> towers,
            Appearance appearance,
            boolean levels,
            boolean borders,
            double marginDecibels) {}

    private final Propagation propagation;
    private final Executor worker;
    private final Executor eventThread;
    private final Runnable changed;
    private LossRaster raster;
    private LossRaster medianRaster;
    private double rasterSquareMetres;
    private Optional<Look> shown = Optional.empty();
    private Optional<Look> wanted = Optional.empty();
    private boolean isComputing;
    private Optional<BufferedImage> image = Optional.empty();

    /** @param changed run on the event thread after a new picture */
    CoverageView(Propagation propagation, Executor worker, Executor eventThread, Runnable changed) {
        this.propagation = propagation;
        this.worker = worker;
        this.eventThread = eventThread;
        this.changed = changed;
    }

    static List<TowerState> states(TownSnapshot snapshot) {
        return snapshot.cells().stream()
                .map((CellState cell) -> new TowerState(cell.isOn(), cell.powerDbm()))
                .toList();
    }

    /** The newest picture; requests another if it does not match these values. On the event thread. */
    Optional<BufferedImage> image(
            TownSnapshot snapshot,
            double pixelsPerMetre,
            Appearance appearance,
            boolean levels,
            boolean borders,
            double marginDecibels) {
        double square = Math.max(
                SQUARE_PIXELS / pixelsPerMetre,
                Math.max(snapshot.town().widthMetres(), snapshot.town().heightMetres()) / COLUMNS_MAX);
        wanted = Optional.of(new Look(square, states(snapshot), appearance, levels, borders, marginDecibels));
        compute();
        return image;
    }

    private void compute() {
        if (isComputing || wanted.equals(shown)) {
            return;
        }
        Look look = wanted.orElseThrow();
        isComputing = true;
        worker.execute(() -> {
            BufferedImage next = draw(look);
            eventThread.execute(() -> {
                isComputing = false;
                shown = Optional.of(look);
                image = Optional.of(next);
                changed.run();
                compute();
            });
        });
    }

    /** Draws on the worker, which alone uses the rasters. */
    private BufferedImage draw(Look look) {
        if (raster == null || rasterSquareMetres != look.squareMetres) {
            raster = LossRaster.of(propagation, look.squareMetres);
            medianRaster = LossRaster.of(propagation.median(), look.squareMetres);
            rasterSquareMetres = look.squareMetres;
        }
        return CoverageImage.of(
                raster.coverage(look.towers),
                medianRaster.coverage(look.towers),
                propagation.town().towers(),
                look.appearance,
                look.levels,
                look.borders,
                look.marginDecibels);
    }
}
