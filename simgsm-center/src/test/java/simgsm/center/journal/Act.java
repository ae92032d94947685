package simgsm.center.journal;

import java.util.random.RandomGenerator;

/** What may happen next in a simulation, and how often as a rule. */
enum Act {
    CARRY(60),
    SERVE_ALL(12),
    COMMIT(8),
    ANSWER(8),
    PASS_MILLIS(10),
    PASS_A_MINUTE(1),
    /** Longer than the first pauses of the retry schedule. */
    PASS_MANY_MINUTES(0.1),
    CONNECT(8),
    WRITE(12),
    DIAL(2),
    PICK_UP(3),
    HANG_UP(1),
    SWITCH_ON(4),
    SWITCH_OFF(0.5),
    VANISH(0.7),
    /** The centre does not notice. */
    VANISH_UNNOTICED(0.5),
    NOTICE(1),
    MEMORY_FULL(0.5),
    MEMORY_FREE(2),
    BROADCAST(0.5),
    APPLICATION_BINDS(3),
    APPLICATION_SUBMITS(4),
    APPLICATION_ANSWERS(6),
    APPLICATION_LEAVES(0.5),
    /** Every operation of the disk may fail from now on. */
    DISK_FAILS(0.3),
    DISK_RECOVERS(1.5),
    /** The machine loses its power between two operations of the disk, or within a write. */
    POWER_CUT(0.5),
    /** The process is killed there; the machine goes on. */
    KILL_IN_DISK(0.5),
    /** The process is killed between two steps; the machine goes on. */
    KILL(0.3);

    private final double usualWeight;

    Act(double usualWeight) {
        this.usualWeight = usualWeight;
    }

    /**
     * The acts of one simulation: of each seed some are frequent, some rare and some never happen, because trouble that
     * comes all at once hides what each kind does alone.
     */
    static Choice choice(RandomGenerator random) {
        Act[] acts = values();
        double[] upTo = new double[acts.length];
        double sum = 0;
        for (int i = 0; i < acts.length; i++) {
            double factor = i <= CONNECT.ordinal() || random.nextInt(4) > 0 ? 0.3 + random.nextDouble() * 2 : 0;
            sum += acts[i].usualWeight * factor;
            upTo[i] = sum;
        }
        return new Choice(acts, upTo);
    }

    /** @param upTo sums of the weights so far */
    record Choice(Act[] acts, double[] upTo) {
        Act next(RandomGenerator random) {
            double at = random.nextDouble() * upTo[upTo.length - 1];
            int i = 0;
            while (upTo[i] <= at) {
                i++;
            }
            return acts[i];
        }
    }
}
