/**
 * The command language of the paper, the robot's status, the verdict on an order and the reply tones. Needs only
 * simgsm.base, for the state tables.
 */
module vericommand {
    requires transitive simgsm.base;

    exports vericommand;
}
