package gamephys;

/** Settings that point to a list, whose memory lives as long as they do. */
abstract class Listed {
    Object list;
}
